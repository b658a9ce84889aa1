#pragma once
#include <optional>

#include "geom/exact_hit.h"

namespace flatray {

/// The point at which a ray arrives at a wall, as ExactHit has it, in double-doubles with bounds; where
/// these leave a doubt, it says so.
///
/// Cost    some 50 ns for a segment, 200 for a curve; a side 5.
struct QuickHit {
  Vec2 nearest;                    ///< nearest double of each coordinate
  bool is_certain = false;         ///< about `nearest`
  Vec2 normal{0, 0};               ///< of a curve nearest doubles of ExactHit::normal
  bool is_normal_certain = false;  ///< about `normal`

  Pair<Near> rest{0, 0};  ///< of the exact point, by which it is not `nearest`
  Pair<Near> form{0, 0};  ///< of a curve: curve_form of the exact point
};

/// Needs   a ray that is not parallel to the wall.
QuickHit quick_hit(const Ray& ray, const Segment& wall, Root = Root::none);
/// Needs   a ray that crosses the curve.
QuickHit quick_hit(const Ray& ray, const Arc& wall, Root root);
/// All in doubt: ExactHit is to tell.
inline QuickHit quick_hit(const Ray&, const Bezier&, Root) { return {}; }

/// Side of the wall hit on which a double near the hit lies, as side_of tells it: by the step from the
/// exact point, which is on the wall. nullopt in doubt.
/// Needs   a certain point, and a double within some ulps of it.
std::optional<Sign> side_by_hit(const Segment& wall, const QuickHit& hit, const Vec2& point);
std::optional<Sign> side_by_hit(const Arc& wall, const QuickHit& hit, const Vec2& point);
inline std::optional<Sign> side_by_hit(const Bezier&, const QuickHit&, const Vec2&) { return {}; }

}  // namespace flatray
