#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace flatray {

void parallel_for(std::size_t count, unsigned threads,
                  const std::function<void(std::size_t)>& task) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> failed{false};
  std::mutex mutex;
  std::exception_ptr first_error;
  // Threads take the next free index until none is left or one task has failed.
  const auto work = [&] {
    while (!failed.load(std::memory_order_relaxed)) {
      const std::size_t index = next.fetch_add(1, std::memory_order_relaxed);
      if (index >= count) return;
      try {
        task(index);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!first_error) first_error = std::current_exception();
        failed.store(true, std::memory_order_relaxed);
      }
    }
  };
  {
    std::vector<std::jthread> helpers;
    try {
      const std::size_t most = std::min<std::size_t>(threads, count);
      helpers.reserve(most);
      for (std::size_t i = 1; i < most; ++i) helpers.emplace_back(work);
    } catch (const std::exception&) {
      // Where the machine gives no more threads, those that it gave do the work.
    }
    work();
  }
  if (first_error) std::rethrow_exception(first_error);
}

unsigned hardware_threads() { return std::max(1U, std::thread::hardware_concurrency()); }

}  // namespace flatray
