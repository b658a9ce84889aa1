#pragma once
#include <atomic>
#include <chrono>
#include <cstddef>
#include <string>

namespace flatray {

/// `always` writes plain lines where there is no terminal; `automatic` writes nothing there.
enum class ProgressMode { automatic, always, never };

/// How far a render has come, on standard error: a bar with rate and time left on a terminal, else
/// five lines. `step` may be called by several threads.
class Progress {
 public:
  /// Of one item nothing is shown, unless it has news to tell.
  Progress(std::size_t total, ProgressMode mode, const char* unit = "frames",
           bool has_news = false);
  void step();
  /// How far the item has come that is under way: beside the bar, or where there are lines a line
  /// each time that the work on it has doubled.
  void tell(const std::string& news);
  /// Clears the bar, so that what follows begins a line.
  void finish();

 private:
  enum class Style { none, bar, lines };
  void draw_bar(std::size_t done, double seconds, const std::string& news = {}) const;

  std::size_t total_;
  const char* unit_;
  Style style_;
  std::chrono::steady_clock::time_point start_;
  std::atomic<std::size_t> done_{0};
  std::atomic<int> shown_{-1};  ///< tenths of a second, or quarters of the work, at the last output
  std::atomic<std::size_t> told_{0};
};

/// Text of the bar: "[#####.....]  60/120  24.1 frames/s  2 s left".
std::string progress_bar(std::size_t done, std::size_t total, double seconds,
                         const char* unit = "frames");

}  // namespace flatray
