#pragma once
#include "geom/primitives/arc.h"
#include "geom/primitives/bezier.h"
#include "trace/rays.h"

namespace flatray {

/// What plain doubles with a bound can say of a ray and a curve.
struct FilteredCurve {
  enum class Verdict : std::uint8_t {
    missed,  ///< surely not met at t >= 0
    sure,    ///< surely crossed at t > 0, there for the first time
    open
  } verdict;
  double low, high;  ///< of the first root ahead, where there is one; `high` only where sure
  Root root;         ///< where sure
};

/// Nothing is sure outside guarded sizes. `left`: the root in which the ray has left this wall, none
/// where it has not.
///
/// Cost    20 ns for a whole curve, 100 for a part of one; of a Bezier curve 30, or 200 where its roots are
///         sought. What it has left plays no part there.
FilteredCurve filter_curve(const Ray& ray, const Arc& wall, Root left);
FilteredCurve filter_curve(const Ray& ray, const Bezier& wall, Root left);
/// For who visits walls that may be straight.
FilteredCurve filter_curve(const Ray& ray, const Segment& wall, Root left);

}  // namespace flatray
