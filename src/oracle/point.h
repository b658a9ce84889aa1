#pragma once
#include <span>
#include <vector>

#include "geom/exact.h"
#include "geom/pair.h"

namespace flatray::oracle {

/// A point or vector of rational numbers.
using Point = Pair<Rational>;
inline Point exact(const Vec2& v) { return {v.x(), v.y()}; }
inline std::vector<Point> exact_ring(std::span<const Vec2> corners) {
  std::vector<Point> ring;
  for (const Vec2& v : corners) ring.push_back(exact(v));
  return ring;
}
inline bool is_zero(const Point& v) { return v.x == 0 && v.y == 0; }

}  // namespace flatray::oracle
