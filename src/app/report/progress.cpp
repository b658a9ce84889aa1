#include "app/report/progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include <bit>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace flatray {
namespace {

constexpr std::size_t kBarWidth = 24;

bool is_terminal() {
  const char* kind = std::getenv("TERM");
  return ::isatty(STDERR_FILENO) != 0 && kind != nullptr && std::string_view(kind) != "dumb";
}

void print(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stderr); }

}  // namespace

std::string progress_bar(std::size_t done, std::size_t total, double seconds, const char* unit) {
  const std::size_t filled = total == 0 ? kBarWidth : done * kBarWidth / total;
  std::string text = fmt::format("[{}{}]  {}/{}", std::string(filled, '#'),
                                 std::string(kBarWidth - filled, '.'), done, total);
  if (done == 0 || !(seconds > 0)) return text;
  const double rate = static_cast<double>(done) / seconds;
  return text + fmt::format("  {:.1f} {}/s  {:.0f} s left", rate, unit,
                            static_cast<double>(total - done) / rate);
}

Progress::Progress(std::size_t total, ProgressMode mode, const char* unit, bool has_news)
    : total_(total), unit_(unit), style_(Style::none), start_(std::chrono::steady_clock::now()) {
  if (mode == ProgressMode::never || (total < 2 && !has_news)) return;
  if (is_terminal())
    style_ = Style::bar;
  else if (mode == ProgressMode::always)
    style_ = Style::lines;
  if (style_ == Style::bar) draw_bar(0, 0);
}

void Progress::draw_bar(std::size_t done, double seconds, const std::string& news) const {
  const std::string gap(3, ' ');
  print("\r" + progress_bar(done, total_, seconds, unit_) + gap + news + (news.empty() ? "" : gap));
}

void Progress::tell(const std::string& news) {
  const std::size_t times = told_.fetch_add(1) + 1;
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  if (style_ == Style::lines && std::has_single_bit(times))
    print(fmt::format("flatray: {}\n", news));
  if (style_ != Style::bar) return;
  const int now = static_cast<int>(elapsed.count() * 10);
  int before = shown_.load();
  if (now > before && shown_.compare_exchange_strong(before, now))
    draw_bar(done_.load(), elapsed.count(), news);
}

void Progress::step() {
  const std::size_t done = done_.fetch_add(1) + 1;
  if (style_ == Style::none) return;
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  const int now = style_ == Style::bar ? static_cast<int>(elapsed.count() * 10)
                                       : static_cast<int>(done * 4 / total_);
  int before = shown_.load();
  // One of the threads that come at the same moment draws.
  if (now <= before || !shown_.compare_exchange_strong(before, now)) return;
  if (style_ == Style::bar)
    draw_bar(done, elapsed.count());
  else
    print(fmt::format("flatray: {} %, {} of {} {}\n", 100 * done / total_, done, total_, unit_));
}

void Progress::finish() {
  if (style_ == Style::bar) print("\r" + std::string(kBarWidth + 90, ' ') + "\r");
}

}  // namespace flatray
