#pragma once
#include <span>

#include "base/isa.h"
#include "geom/clip.h"
#include "trace/rays.h"

namespace flatray {

/// Parts of many rays inside one closed convex polygon: for edge rays, the view `intervals` and the
/// library. (`flatray hit` clips one by one: app/answers/hit_report.cpp.)
///
/// Needs   `polygon` as clip_convex does; as many intervals as rays. What the rays have left plays
///         no part. Gives   for each ray what clip_convex gives, bit for bit, from every tier. Cost
///         under 1 ns an edge where the lanes are sure; else clip_convex. O(n + log n a ray) for many
///         edges.
void clip_convex_batch(const RayBatch& rays, std::span<const Vec2> polygon, Range within,
                       std::span<HitInterval> intervals, Isa isa = active_isa());

}  // namespace flatray
