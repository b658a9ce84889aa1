#pragma once
#include "geom/exact.h"

namespace flatray::oracle {

/// Side of `c` seen from a to b, by rational slopes: above or below the line's height at c.x.
/// Exact.
Sign side_of_line(const Vec2& a, const Vec2& b, const Vec2& c);

}  // namespace flatray::oracle
