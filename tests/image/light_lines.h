#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "base/philox.h"
#include "image/light_film.h"

namespace flatray::light_lines {

using Sums = std::vector<std::int64_t>;
using Lines = std::vector<LightLine>;

constexpr double kUnits = 65536;

inline LightLine white(double from_x, double from_y, double to_x, double to_y) {
  return {from_x, from_y, to_x, to_y, {1, 1, 1}};
}

inline Sums sums_of(int width, int height, const Lines& lines, int channels = 1,
                    unsigned threads = 1, Isa isa = active_isa()) {
  LightFilm film(width, height, channels, isa);
  film.add(lines, threads);
  return film.sums();
}

inline double total_of(const Sums& sums) {
  return static_cast<double>(std::accumulate(sums.begin(), sums.end(), std::int64_t{0})) / kUnits;
}

// Numbers on [0, 1) in an order of their own.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : seed_(seed) {}
  double unit() { return unit_double(random_bits(seed_, Stream::test, 0, next_++)); }
  double between(double low, double high) { return low + (high - low) * unit(); }

 private:
  std::uint64_t seed_, next_ = 0;
};

inline LightLine coloured(LightLine line, Draws& draws) {
  for (float& weight : line.weight) weight = static_cast<float>(draws.unit());
  return line;
}

// Lines of every kind: long and short, through corners of pixels, along and nearly along rows and
// columns, from far outside.
inline Lines lines_of_all_kinds(std::size_t count, int width, int height, std::uint64_t seed) {
  Draws draws(seed);
  const auto x = [&] { return draws.between(-20, width + 20); };
  const auto y = [&] { return draws.between(-20, height + 20); };
  Lines lines;
  for (std::size_t i = 0; i < count; ++i) {
    LightLine line{x(), y(), x(), y(), {1, 1, 1}};  // braces: in this order
    const double kind = std::floor(draws.unit() * 8);
    if (kind == 1)
      line.to_x = line.from_x + draws.between(-5, 5),
      line.to_y = line.from_y + draws.between(-5, 5);
    if (kind == 2)
      line = {std::floor(x()), std::floor(y()), std::floor(x()), std::floor(y()), {1, 1, 1}};
    const double small = std::ldexp(draws.between(-1, 1), -static_cast<int>(i % 60));
    if (kind == 3) line.to_y = line.from_y + small;
    if (kind == 4) line.to_x = line.from_x + small;
    if (kind == 5) line.to_y = line.from_y = std::floor(line.from_y);
    if (kind == 6) line.to_x = line.from_x = std::floor(line.from_x);
    if (kind == 7) {
      const double far = std::ldexp(1, static_cast<int>(30 * draws.unit()));
      line.to_x = (line.to_x - line.from_x) * far, line.to_y = (line.to_y - line.from_y) * far;
    }
    lines.push_back(coloured(line, draws));
  }
  return lines;
}

}  // namespace flatray::light_lines
