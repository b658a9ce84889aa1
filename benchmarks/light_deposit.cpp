// What does a film of exact lengths cost? Steps (columns, or rows, that lines cross) a second of LightFilm at 1920x1080,
// in colour and in one channel, beside a loop that adds each line to an int64 image by itself.
#include <fmt/core.h>

#include <cmath>
#include <cstdlib>
#include <numeric>

#include "base/philox.h"
#include "image/light_film.h"
#include "measure.h"

namespace {

using namespace flatray;

constexpr int kWidth = 1920, kHeight = 1080;
constexpr int kRounds = 9;

// Exact lengths, line by line, into 64 bits a channel: what is to be beaten.
class DirectFilm {
 public:
  void add(std::span<const LightLine> lines) {
    for (const LightLine& line : lines) add(line);
  }
  std::int64_t total() const {
    return std::accumulate(sums_.begin(), sums_.end(), std::int64_t{0});
  }

 private:
  // Lines inside the film alone.
  void add(const LightLine& line) {
    const double dx = line.to_x - line.from_x, dy = line.to_y - line.from_y;
    if (std::fabs(dx) >= std::fabs(dy))
      add(line, line.from_x, line.from_y, line.to_x, line.to_y, 3, 3 * kWidth);
    else
      add(line, line.from_y, line.from_x, line.to_y, line.to_x, 3 * kWidth, 3);
  }

  void add(const LightLine& line, double u0, double v0, double u1, double v1, std::ptrdiff_t major,
           std::ptrdiff_t minor) {
    if (u1 < u0) std::swap(u0, u1), std::swap(v0, v1);
    const double slope = (v1 - v0) / (u1 - u0);
    const double units = 65536 * std::sqrt(1 + slope * slope);
    double weight[3];
    for (std::size_t c = 0; c < 3; ++c) weight[c] = units * static_cast<double>(line.weight[c]);
    const int last = static_cast<int>(std::ceil(u1));
    for (int column = static_cast<int>(u0); column < last; ++column) {
      const double from = std::max<double>(column, u0), to = std::min<double>(column + 1, u1);
      const double enter = v0 + slope * (from - u0), leave = v0 + slope * (to - u0);
      const int row = static_cast<int>(enter), row_after = static_cast<int>(leave);
      std::int64_t* first = sums_.data() + column * major + row * minor;
      if (row == row_after) {
        for (int c = 0; c < 3; ++c) first[c] += whole((to - from) * weight[c]);
        continue;
      }
      const double border = std::max(row, row_after);
      const double middle = std::clamp((border - v0) / slope + u0, from, to);
      std::int64_t* next = sums_.data() + column * major + row_after * minor;
      for (int c = 0; c < 3; ++c) first[c] += whole((middle - from) * weight[c]);
      for (int c = 0; c < 3; ++c) next[c] += whole((to - middle) * weight[c]);
    }
  }

  static std::int64_t whole(double units) { return static_cast<std::int64_t>(units + 0.5); }

  std::vector<std::int64_t> sums_ =
      std::vector<std::int64_t>(std::size_t{3} * (kWidth + 1) * (kHeight + 1));
};

double draw(std::size_t item, std::uint32_t number) {
  return unit_double(random_bits(7, Stream::test, 0, item, number));
}

// From one random point of the film to another: 730 steps in the mean.
LightLine long_line(std::size_t i) {
  return {draw(i, 0) * kWidth, draw(i, 1) * kHeight, draw(i, 2) * kWidth, draw(i, 3) * kHeight, {}};
}

// 31 pixels from a random point in a random direction, 28 steps in the mean.
LightLine short_line(std::size_t i) {
  const double x = 32 + draw(i, 0) * (kWidth - 64), y = 32 + draw(i, 1) * (kHeight - 64);
  const double turn = draw(i, 2) * 6.283185307179586;
  return {x, y, x + 31 * std::cos(turn), y + 31 * std::sin(turn), {}};
}

// 500 pixels from one point, in random order.
LightLine fan_line(std::size_t i) {
  const double turn = draw(i, 0) * 6.283185307179586;
  return {960.3, 540.7, 960.3 + 500 * std::cos(turn), 540.7 + 500 * std::sin(turn), {}};
}

std::vector<LightLine> lines_of(std::size_t count, LightLine (*line)(std::size_t)) {
  std::vector<LightLine> lines;
  for (std::size_t i = 0; i < count; ++i) {
    lines.push_back(line(i));
    for (std::uint32_t c = 0; c < 3; ++c)
      lines.back().weight[c] = static_cast<float>(0.1 + 0.9 * draw(i, 4 + c));
  }
  return lines;
}

double steps_of(const std::vector<LightLine>& lines) {
  double steps = 0;
  for (const LightLine& line : lines)
    steps += std::max(std::fabs(line.to_x - line.from_x), std::fabs(line.to_y - line.from_y));
  return steps;
}

void check_totals(const std::vector<LightLine>& lines) {
  DirectFilm direct;
  LightFilm film(kWidth, kHeight, 3);
  direct.add(lines);
  film.add(lines);
  const std::vector<std::int64_t> sums = film.sums();
  const auto total =
      static_cast<double>(std::accumulate(sums.begin(), sums.end(), std::int64_t{0}));
  if (std::fabs(total / static_cast<double>(direct.total()) - 1) < 1e-6) return;
  fmt::print(stderr, "the films differ\n");
  std::exit(1);
}

void measure(const char* name, const std::vector<LightLine>& lines) {
  check_totals(lines);
  DirectFilm direct;
  LightFilm colour(kWidth, kHeight, 3), grey(kWidth, kHeight, 1), shared(kWidth, kHeight, 3);
  const std::vector<double> times = bench::compare({{"direct", [&] { direct.add(lines); }},
                                                    {"colour", [&] { colour.add(lines); }},
                                                    {"one channel", [&] { grey.add(lines); }}},
                                                   kRounds);
  const std::vector<bench::Contender> threads = {{"one", [&] { colour.add(lines, 1); }},
                                                 {"two", [&] { shared.add(lines, 2); }}};
  const std::vector<double> work = bench::compare(threads, kRounds, 0.05, CLOCK_PROCESS_CPUTIME_ID);
  const std::vector<double> walls = bench::compare(threads, kRounds, 0.05, CLOCK_MONOTONIC);
  const double steps = 1e-6 * steps_of(lines);
  fmt::print("{:>6} {:>7.0f} {:>8.0f} {:>8.0f} {:>8.0f} {:>8.2f} {:>8.2f} {:>8.2f} {:>8.2f}\n",
             name, 1e6 * steps / static_cast<double>(lines.size()), steps / times[0],
             steps / times[1], steps / times[2], times[0] / times[1], times[0] / times[2],
             2 * work[0] / work[1], walls[0] / walls[1]);
}

}  // namespace

int main() {
  fmt::print(
      "{}: millions of steps a second; colour and one channel against direct; two threads against "
      "one in colour, by CPU rates and by the wall\n",
      isa_name(active_isa()));
  fmt::print("{:>6} {:>7} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8}\n", "lines", "steps", "direct",
             "colour", "one", "colour x", "one x", "two, CPU", "wall");
  measure("long", lines_of(1U << 17, long_line));
  measure("short", lines_of(1U << 20, short_line));
  measure("fan", lines_of(1U << 17, fan_line));
}
