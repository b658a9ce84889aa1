#pragma once
#include "geom/primitives/arc.h"
#include "geom/primitives/bezier.h"
#include "trace/segment_filter.h"

namespace flatray {

/// What plain doubles with a bound can say of a ray and a curve: `low` and `high` are of the first root ahead,
/// where there is one, `high` only where that is sure.
///
/// Nothing is sure outside guarded sizes. `left`: the root in which the ray has left this wall, none
/// where it has not.
///
/// Cost    20 ns for a whole curve, 100 for a part of one; of a Bezier curve 30, or 200 where its roots are
///         sought. What it has left plays no part there.
FilteredHit filter_curve(const Ray& ray, const Arc& wall, Root left);
FilteredHit filter_curve(const Ray& ray, const Bezier& wall, Root left);
/// For who visits walls that may be straight.
FilteredHit filter_curve(const Ray& ray, const Segment& wall, Root left);

}  // namespace flatray
