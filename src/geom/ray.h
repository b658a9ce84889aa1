#pragma once
#include <cstdint>
#include <limits>

#include "geom/vec.h"

namespace flatray {

/// origin + t * direction. `direction` has any length; zero makes the query a point test.
struct Ray {
  Vec2 origin, direction;
};

/// Closed range of t a query is clipped to.
struct Range {
  double low, high;
};
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr Range kLine{-kInfinity, kInfinity}, kRay{0, kInfinity}, kSegment{0, 1};

/// Which of the points in which the line of a ray meets a curve: it enters by the first root and
/// leaves by the second; a tangent has `both` in one. A cubic may be entered once more, by the
/// third, or left once more, by the fourth.
enum class Root : std::uint8_t { none, first, second, both, third, fourth };

/// Whether a ray enters by it: comes from outside, or from the left of a Bezier curve.
constexpr bool enters(Root root) { return root == Root::first || root == Root::third; }

/// The sign of the square root in the formula for t: 1 in the second root, else -1.
inline int root_sign(Root root) { return root == Root::second ? 1 : -1; }

struct Segment {
  Vec2 a, b;
  bool operator==(const Segment&) const = default;
};

struct Circle {
  Vec2 centre;
  double radius;  ///< 0 is a point
};

}  // namespace flatray
