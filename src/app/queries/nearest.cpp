#include "app/query/query.h"
#include "app/report/report.h"
#include "trace/tracer.h"
#include "transport/hit_point.h"

namespace flatray::nearest_query {
namespace {

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
  // A time that rounds to the largest double lies beyond it, or within half an ulp of it.
  if (hit.t == std::numeric_limits<double>::max()) fields.emplace_back("overflow", true);
  return fields;
}

}  // namespace

extern const Query entry = {"nearest", "the first wall a ray meets", &answer};

}  // namespace flatray::nearest_query
