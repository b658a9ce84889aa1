#include "trace/plain_arrays.h"

#include <algorithm>
#include <cmath>

#include "geom/polygon.h"

namespace flatray::api {

Status check_columns(std::initializer_list<Column> columns) {
  const std::size_t count = columns.begin()->size();
  for (const Column& column : columns)
    if (column.size() != count) return {Fault::sizes, 0};
  std::size_t first = count;
  for (const Column& column : columns) {
    const auto wrong = std::find_if_not(column.begin(), column.end(),
                                        [](double number) { return std::isfinite(number); });
    first = std::min(first, static_cast<std::size_t>(wrong - column.begin()));
  }
  return first == count ? Status{} : Status{Fault::not_finite, first};
}

Status check_range(Range within) {
  return std::isnan(within.low) || std::isnan(within.high) ? Status{Fault::not_finite, 0}
                                                           : Status{};
}

Status check_rays(const Rays& rays, std::size_t walls) {
  const Status fault = check_columns({rays.ox, rays.oy, rays.dx, rays.dy});
  if (!fault) return fault;
  if (!rays.departed.empty() && rays.departed.size() != rays.size()) return {Fault::sizes, 0};
  for (std::size_t i = 0; i < rays.departed.size(); ++i)
    if (rays.departed[i].wall >= walls && rays.departed[i].wall != kNoWall)
      return {Fault::no_such, i};
  return {};
}

Status check_convex(Column x, Column y) {
  if (const Status fault = check_columns({x, y}); !fault) return fault;
  if (x.empty()) return {Fault::empty, 0};
  const auto vertex = non_convex_vertex(points_of(x, y));
  return vertex ? Status{Fault::not_convex, *vertex} : Status{};
}

std::vector<Vec2> points_of(Column x, Column y) {
  std::vector<Vec2> points;
  points.reserve(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) points.emplace_back(x[i], y[i]);
  return points;
}

Ray ray_of(const Rays& rays, std::size_t i) {
  return {{rays.ox[i], rays.oy[i]}, {rays.dx[i], rays.dy[i]}};
}

void load(const Rays& rays, std::size_t begin, std::size_t count, RayBatch& batch) {
  batch.tangents = rays.tangents;
  batch.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const DepartedSurface from =
        rays.departed.empty() ? DepartedSurface{} : rays.departed[begin + i];
    batch.set(i, ray_of(rays, begin + i), {from.wall, static_cast<flatray::Root>(from.root)});
  }
}

Interval interval_of(const HitInterval& hit) {
  return {hit.t_enter,
          hit.t_exit,
          hit.edge_enter,
          hit.edge_exit,
          static_cast<HitClass>(hit.kind),
          static_cast<StartPlace>(hit.start),
          hit.enter_overflows,
          hit.exit_overflows};
}

}  // namespace flatray::api
