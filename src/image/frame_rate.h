#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace flatray {

/// A quotient of whole numbers.
struct Ratio {
  std::uint32_t over, under;
};

/// A number as video files have it: 24 as 24/1, 29.97 as 2997/100, 24000.0 / 1001 as just that.
///
/// Needs   value > 0, most > 0.
/// Gives   the last convergent of its continued fraction whose two numbers are at most `most`; numbers
///         beyond `most` and below 1 / `most` as these. The same on every machine.
inline Ratio nearest_ratio(double value, std::uint32_t most) {
  const double limit = most;
  double rest = std::clamp(value, 1 / limit, limit);
  double over = 1, under = 0, over_before = 0, under_before = 1;
  for (;;) {
    const double whole = std::floor(rest);
    const double next_over = whole * over + over_before, next_under = whole * under + under_before;
    if (next_over > limit || next_under > limit) break;
    over_before = over, under_before = under;
    over = next_over, under = next_under;
    if (rest == whole) break;
    rest = 1 / (rest - whole);
  }
  return {static_cast<std::uint32_t>(over), static_cast<std::uint32_t>(under)};
}

}  // namespace flatray
