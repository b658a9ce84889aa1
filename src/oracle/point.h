#pragma once
#include "geom/exact.h"
#include "geom/pair.h"

namespace flatray::oracle {

/// A point or vector of rational numbers.
using Point = Pair<Rational>;
inline Point exact(const Vec2& v) { return {v.x(), v.y()}; }
inline bool is_zero(const Point& v) { return v.x == 0 && v.y == 0; }

}  // namespace flatray::oracle
