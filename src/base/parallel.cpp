#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace flatray {
namespace {

// Threads take the next free index until none is left or one task has failed.
class Loop {
 public:
  Loop(std::size_t count, const std::function<void(std::size_t)>& task)
      : count_(count), task_(task) {}

  void work() {
    while (!failed_.load(std::memory_order_relaxed)) {
      const std::size_t index = next_.fetch_add(1, std::memory_order_relaxed);
      if (index >= count_) return;
      try {
        task_(index);
      } catch (...) {
        keep_first_error();
      }
    }
  }

  void rethrow() {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  void keep_first_error() {
    const std::lock_guard lock(mutex_);
    if (!error_) error_ = std::current_exception();
    failed_.store(true, std::memory_order_relaxed);
  }

  const std::size_t count_;
  const std::function<void(std::size_t)>& task_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> failed_{false};
  std::mutex mutex_;
  std::exception_ptr error_;
};

// Where the machine gives no more threads, those that it gave do the work.
void start_helpers(std::vector<std::jthread>& helpers, std::size_t threads, Loop& loop) {
  try {
    helpers.reserve(threads);
    for (std::size_t i = 1; i < threads; ++i) helpers.emplace_back([&loop] { loop.work(); });
  } catch (const std::exception&) {
  }
}

}  // namespace

void parallel_for(std::size_t count, unsigned threads,
                  const std::function<void(std::size_t)>& task) {
  Loop loop(count, task);
  {
    std::vector<std::jthread> helpers;
    start_helpers(helpers, std::min<std::size_t>(threads, count), loop);
    loop.work();
  }
  loop.rethrow();
}

unsigned hardware_threads() { return std::max(1U, std::thread::hardware_concurrency()); }

}  // namespace flatray
