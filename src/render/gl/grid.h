#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geom/bounds.h"

namespace flatray::gl {

/// Rasterizers round corners to 1/256 of a pixel. It is done here first, so that what is drawn is
/// known exactly and does not depend on where a tile begins.
inline constexpr double kGridSteps = 256;

struct GridPoint {
  std::int64_t x, y;
  auto operator<=>(const GridPoint&) const = default;
};

/// Nearest point of the grid, halves up. Needs   |coordinates| < 2^40.
GridPoint on_grid(const Vec2& point);

/// Twice the signed area of the triangle a, b, c. Exact for coordinates below 2^30.
std::int64_t area(const GridPoint& a, const GridPoint& b, const GridPoint& c);

/// As often as closed figures can wind round any point, or more.
///
/// Gives   half the most sides that any horizontal line meets, or any vertical one where these are
///         fewer: going out of the figures on either side, a winding changes at each side by one.
/// Cost    O(n log n) for n sides; O(1) where n/2 is at most `enough`, which is then the answer.
std::size_t most_windings(std::span<const std::vector<GridPoint>> figures, std::size_t enough);

/// Corners of the convex hull in order, none on a line with its neighbours; fewer than three where
/// it has no area. What was convex before it was rounded moves by no more than the rounding.
std::vector<GridPoint> hull(std::vector<GridPoint> points);

}  // namespace flatray::gl
