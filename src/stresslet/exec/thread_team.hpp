#pragma once
/// A fixed team of threads that run one function together (single program, multiple data) and meet at barriers.
///
/// Work is split by `Member::share`, whose pieces depend on the number of threads; results must not. Kernels
/// therefore write per item, or sum over chunks of fixed length (see `chunk_sum.hpp`), and never reduce per thread.
/// The barrier spins briefly, then yields, then sleeps; it uses plain atomics so that the thread sanitizer understands
/// it.
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <thread>
#include <type_traits>
#include <vector>

namespace stresslet {

struct Range {
  std::size_t begin, end;
};

class ThreadTeam;

/// What one thread of the team sees while it runs.
class Member {
 public:
  Member(ThreadTeam& team, int rank) : team_(team), rank_(rank) {}
  int rank() const { return rank_; }
  inline int size() const;
  inline void barrier();

  /// This thread's part of [0, count), its ends rounded to multiples of `grain`.
  Range share(std::size_t count, std::size_t grain = 1) const {
    const std::size_t grains = (count + grain - 1) / grain;
    const auto bound = [&](int r) { return std::min(count, grain * (grains * std::size_t(r) / std::size_t(size()))); };
    return {bound(rank_), bound(rank_ + 1)};
  }

 private:
  ThreadTeam& team_;
  int rank_;
};

class ThreadTeam {
 public:
  explicit ThreadTeam(int size);
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  int size() const { return int(workers_.size()) + 1; }

  /// Runs `body(Member&)` on every thread and returns when all have finished. Not re-entrant. An exception may be
  /// thrown only where every thread of the team throws; the first thread's reaches the caller.
  template <class Body>
  void run(Body&& body) {
    job_ = {[](void* b, Member& m) { (*static_cast<std::remove_reference_t<Body>*>(b))(m); }, &body};
    start();
  }

  void barrier();

 private:
  struct Job {
    void (*call)(void*, Member&) = nullptr;
    void* body = nullptr;
  };
  void start();
  void work(int rank);
  void execute(int rank);

  Job job_;
  std::vector<std::thread> workers_;
  std::vector<std::exception_ptr> failures_;
  alignas(64) std::atomic<std::uint32_t> epoch_{0};
  alignas(64) std::atomic<std::uint32_t> arrived_{0};
  alignas(64) std::atomic<std::uint32_t> generation_{0};
  std::atomic<bool> stopping_{false};
};

inline int Member::size() const { return team_.size(); }
inline void Member::barrier() { team_.barrier(); }

}  // namespace stresslet
