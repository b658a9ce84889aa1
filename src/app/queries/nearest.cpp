#include <algorithm>
#include <limits>

#include "app/query/query.h"
#include "app/report/report.h"
#include "geom/primitives/wall.h"
#include "trace/tracer.h"
#include "transport/hit_point.h"

namespace flatray::nearest_query {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();

// Whether the ray, which is not a point, meets a wall at no t that doubles reach.
bool is_met_beyond(const Surfaces& walls, const Ray& ray, std::uint32_t surface) {
  std::vector<WallMeeting> met;
  walls.visit(surface, [&](const auto& wall) { meet(wall, ray, {.every = true}, met); });
  return std::ranges::none_of(met, [](const WallMeeting& one) {
    return one.time.sign() != Sign::negative && one.time.compare(kLargest) <= 0;
  });
}

Fields answer(Question& question) {
  const Ray ray = question.ray();
  const Surfaces walls = question.walls("walls");
  if (!question.sound()) return {};
  RayBatch rays;
  rays.add(ray);
  NearestHit hit;
  const Tracer* tracer = question.precision().tracer;
  (tracer == nullptr ? accelerate(walls) : tracer->build(walls))->nearest(rays, {&hit, 1});
  if (!hit) return {{"wall", JsonValue()}};
  Fields fields = {{"wall", hit.surface},
                   {"t", hit.t},
                   {"point", as_value(hit_point(walls, ray, hit))},
                   {"class", name(hit.kind)}};
  if (hit.t == kLargest && is_met_beyond(walls, ray, hit.surface))
    fields.emplace_back("overflow", true);
  return fields;
}

}  // namespace

extern const Query entry = {"nearest", "the first wall a ray meets", &answer};

}  // namespace flatray::nearest_query
