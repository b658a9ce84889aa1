#pragma once
#include <fmt/core.h>

#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <string>

namespace flatray {

/// Stops the program where one input takes more than a second of its thread's own time, which other
/// programs on the machine do not change. Sanitizers included.
class OneSecond {
 public:
  OneSecond() : start_(now()) {}
  OneSecond(const OneSecond&) = delete;
  OneSecond& operator=(const OneSecond&) = delete;
  ~OneSecond() {
    const double seconds = now() - start_;
    if (seconds <= 1) return;
    fmt::print(stderr, "{:.2f} s of CPU for one input\n", seconds);
    std::abort();
  }

 private:
  static double now() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }
  double start_;
};

inline std::string text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace flatray

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
