#include "stresslet/exec/thread_team.hpp"

namespace stresslet {

namespace {

// Pauses, about 10 us: longer than most waits of a team that has its cores for itself. Then yields, which cost little
// on idle cores and let other processes run on busy ones, and at last sleep.
constexpr int pauses = 300, yields = 50;

void relax() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

/// Returns once `word` differs from `seen`.
void wait_for_change(const std::atomic<std::uint32_t>& word, std::uint32_t seen) {
  for (int spin = 0; spin < pauses + yields; ++spin) {
    if (word.load(std::memory_order_acquire) != seen) return;
    if (spin < pauses)
      relax();
    else
      std::this_thread::yield();
  }
  while (word.load(std::memory_order_acquire) == seen) word.wait(seen, std::memory_order_acquire);
}

}  // namespace

ThreadTeam::ThreadTeam(int size) : failures_(std::size_t(size)) {
  for (int rank = 1; rank < size; ++rank) workers_.emplace_back([this, rank] { work(rank); });
}

ThreadTeam::~ThreadTeam() {
  stopping_ = true;
  epoch_.fetch_add(1, std::memory_order_release);
  epoch_.notify_all();
  for (auto& worker : workers_) worker.join();
}

void ThreadTeam::execute(int rank) {
  Member member(*this, rank);
  try {
    job_.call(job_.body, member);
  } catch (...) {
    failures_[std::size_t(rank)] = std::current_exception();
  }
}

void ThreadTeam::start() {
  epoch_.fetch_add(1, std::memory_order_release);
  epoch_.notify_all();
  execute(0);
  barrier();
  const std::exception_ptr failure = failures_[0];
  for (auto& f : failures_) f = nullptr;
  if (failure) std::rethrow_exception(failure);
}

void ThreadTeam::work(int rank) {
  for (std::uint32_t seen = 0;; ++seen) {
    wait_for_change(epoch_, seen);
    if (stopping_) return;
    execute(rank);
    barrier();
  }
}

void ThreadTeam::barrier() {
  if (workers_.empty()) return;
  const std::uint32_t generation = generation_.load(std::memory_order_acquire);
  if (arrived_.fetch_add(1, std::memory_order_acq_rel) + 1 == std::uint32_t(size())) {
    arrived_.store(0, std::memory_order_relaxed);
    generation_.fetch_add(1, std::memory_order_release);
    generation_.notify_all();
  } else {
    wait_for_change(generation_, generation);
  }
}

}  // namespace stresslet
