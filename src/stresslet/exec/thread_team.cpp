#include "stresslet/exec/thread_team.hpp"

namespace stresslet {

namespace {

// Spins last some 3 us, about the imbalance between barriers; a longer spin wastes the time slice of the partner where
// both share a core. Yields hand it over, and cost nothing on a core of one's own.
constexpr int spins_before_yield = 100;
constexpr int yields_before_sleep = 1000;

void relax() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

/// Returns once `word` differs from `seen`.
void wait_for_change(const std::atomic<std::uint32_t>& word, std::uint32_t seen) {
  for (int spin = 0; spin < spins_before_yield; ++spin) {
    if (word.load(std::memory_order_acquire) != seen) return;
    relax();
  }
  for (int yield = 0; yield < yields_before_sleep; ++yield) {
    if (word.load(std::memory_order_acquire) != seen) return;
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
