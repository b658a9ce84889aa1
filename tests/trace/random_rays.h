#pragma once
#include <cmath>

#include "base/philox.h"
#include "geom/ray.h"

namespace flatray {

/// Draws of one test, in order.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : seed_(seed) {}
  std::uint64_t bits() { return random_bits(seed_, Stream::test, 0, next_++); }
  double unit() { return unit_double(bits()); }
  /// A whole number from `low` to `high`.
  int whole(int low, int high) {
    return low + static_cast<int>(bits() % static_cast<std::uint64_t>(high - low + 1));
  }
  Vec2 grid_point(int low, int high) {
    const double x = whole(low, high);
    return {x, static_cast<double>(whole(low, high))};
  }
  Vec2 point() {
    const double x = unit();
    return {x, unit()};
  }
  /// Of either sign, its size anywhere from 2^low to 2^high.
  double spread(int low, int high) {
    const double size = std::ldexp(0.5 + 0.5 * unit(), whole(low, high));
    return bits() % 2 == 0 ? size : -size;
  }

 private:
  std::uint64_t seed_, next_ = 0;
};

}  // namespace flatray
