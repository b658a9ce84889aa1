#include "app/query/query.h"
#include "trace/tracer.h"
#include "transport/hit_point.h"

namespace flatray::queries {
namespace {

Fields answer(Question& question) {
  const Ray ray = question.ray();
  const Surfaces walls = question.walls("walls");
  if (!question.sound()) return {};
  RayBatch rays;
  rays.add(ray);
  NearestHit hit;
  accelerate(walls)->nearest(rays, {&hit, 1});
  if (!hit) return {{"wall", JsonValue()}};
  const Vec2 point = hit_point(walls, ray, hit);
  return {{"wall", hit.surface},
          {"t", hit.t},
          {"point", Values{point.x(), point.y()}},
          {"class", name(hit.kind)}};
}

}  // namespace

extern const Query nearest = {"nearest", "the first wall a ray meets", &answer};

}  // namespace flatray::queries
