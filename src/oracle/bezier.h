#pragma once
#include <optional>
#include <vector>

#include "oracle/algebraic.h"
#include "oracle/curves.h"

namespace flatray::oracle {

/// A point that a ray and a Bezier curve share, at parameter s of the curve; of a weighted one s is told at
/// its ends alone, and is 1/2 between them.
struct BezierMeeting {
  Algebraic t, s;
  int multiplicity;  ///< of the root: 1 where the ray crosses, 2 on a tangent, 3 on one that crosses
  Root root;         ///< as geom/ray.h names it, among all of the line of the ray
  bool at_cusp;

  bool at_end() const {
    return at_cusp || s.sign() == Sign::zero || s.sign_of({-1, 1}) == Sign::zero;
  }
};

/// All of them at t >= 0, in the order of t, and at one t in that of s. A ray without direction asks
/// where on the curve its origin lies: t and the multiplicity are 0 there.
///
/// Needs   control points that are not all on the line of the ray.
/// Source  the curve by powers of s, from differences of its control points; roots of what lies beside
///         the ray as a polynomial in s, and t as what lies ahead at them. Of a weighted curve its equation
///         along the ray, of degree 2 in t. In rationals.
/// Cost    some 100 us.
std::vector<BezierMeeting> meetings_with_bezier(const Ray& ray, const Bezier& curve);

/// The first of them, where the curve is met at several s at once all together: at an end, as in a
/// cusp or at an end of the curve, and a touch if none of them crosses the ray; in the last root that does.
std::optional<WallHitOf<Algebraic>> first_wall_hit(const Ray& ray, const Bezier& curve);

}  // namespace flatray::oracle
