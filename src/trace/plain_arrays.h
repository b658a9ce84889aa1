#pragma once
#include <initializer_list>
#include <span>
#include <vector>

#include "flatray/trace.h"
#include "geom/hit_interval.h"
#include "trace/rays.h"

/// What the public calls have in common: the arrays of others, checked and as the library has them.
namespace flatray::api {

using Column = std::span<const double>;

/// Whether arrays are as long as the first of them, and all numbers finite.
Status check_columns(std::initializer_list<Column> columns);
/// Whether no end of a range is NaN.
Status check_range(Range within);
/// Whether rays are as their tracer needs them; `walls`: how many they may have left.
Status check_rays(const Rays& rays, std::size_t walls);
/// Whether a polygon has a vertex and is convex.
Status check_convex(Column x, Column y);

/// Needs   arrays that were checked.
std::vector<Vec2> points_of(Column x, Column y);
Ray ray_of(const Rays& rays, std::size_t i);
/// `count` of the rays from `begin` on into a batch that is used again.
void load(const Rays& rays, std::size_t begin, std::size_t count, RayBatch& batch);
Interval interval_of(const HitInterval& hit);

/// Rays that are copied at once: their columns stay in the second cache.
inline constexpr std::size_t kRaysAtOnce = 4096;

}  // namespace flatray::api
