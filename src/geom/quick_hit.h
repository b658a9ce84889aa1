#pragma once
#include <optional>

#include "geom/hit_time.h"

namespace flatray {

/// The point at which a ray arrives at a wall, as ExactHit has it, in doubles with bounds; where
/// these leave a doubt, it says so.
///
/// Cost    some 50 ns for a segment, 200 for a curve; a side 2.
struct QuickHit {
  Vec2 nearest;                    ///< nearest double of each coordinate
  bool is_certain = false;         ///< about `nearest`
  Vec2 normal{0, 0};               ///< of a curve nearest doubles of ExactHit::normal
  bool is_normal_certain = false;  ///< about `normal`

  /// Side of the wall on which a double lies: positive to the left of a segment, outside a curve,
  /// zero on it; nullopt in doubt. Needs a certain point, and a double within some ulps of it.
  std::optional<Sign> side(const Vec2& point) const {
    // As the exact point is on the wall, only the step from there counts: along the gradient, and
    // on curves by a bend of its square.
    const Vec2 step = (point - nearest) - rest;
    const double x = gradient.x() * step.x(), y = gradient.y() * step.y(), value = x + y;
    const double reach = std::fabs(step.x()) + std::fabs(step.y()) + error.x() + error.y();
    const double bound =
        0x1p-48 * (std::fabs(x) + std::fabs(y)) +
        2 * (std::fabs(gradient.x()) * error.x() + std::fabs(gradient.y()) * error.y()) +
        reach * (gradient_error + bend * reach) + least;
    if (std::fabs(value) > bound || bound == 0) return sign_of(value);
    return std::nullopt;
  }

  // What `side` needs. Upright and level walls have one coordinate without error.
  Vec2 rest{0, 0}, error{0, 0};  // the exact point is nearest + rest, but for `error`
  Vec2 gradient{0, 0};           // times 2^500, so that products with steps are no subnormals
  double gradient_error = 0, bend = 0, least = 0;  // twice what they need be
};

/// Needs   a ray that is not parallel to the wall.
QuickHit quick_hit(const Ray& ray, const Segment& wall, Root = Root::none);
/// Needs   a ray that crosses the curve.
QuickHit quick_hit(const Ray& ray, const Ellipse& wall, Root root);
inline QuickHit quick_hit(const Ray& ray, const Arc& wall, Root root) {
  return quick_hit(ray, wall.curve, root);
}
/// All in doubt: ExactHit is to tell.
inline QuickHit quick_hit(const Ray&, const Bezier&, Root) { return {}; }

/// geom/reflect.h's `reflect`, or NaN in doubt. Cost   some 30 ns.
Vec2 quick_reflection(const Vec2& direction, const Vec2& along);

}  // namespace flatray
