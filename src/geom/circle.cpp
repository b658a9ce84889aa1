#include "geom/clip.h"
#include "geom/clip_range.h"

namespace flatray {
namespace {

HitInterval clip(const Ray& ray, const Ellipse& ellipse, Range within, const Vec2& velocity) {
  if (ray.direction == velocity) {
    const Sign side = curve_side(ray.origin, ellipse);
    return point_test(side == Sign::positive ? StartPlace::outside
                      : side == Sign::zero   ? StartPlace::boundary
                                             : StartPlace::inside,
                      within);
  }
  const auto line = hit_curve(ray, ellipse, velocity);
  if (!line) return {};
  // There is no straight boundary to run along.
  const HitClass kind = line->tangent ? HitClass::touch : HitClass::through;
  return clip_to_range({line->first, line->second, kNoEdge, kNoEdge, kind}, within);
}

}  // namespace

HitInterval clip_ellipse(const Ray& ray, const Ellipse& ellipse, Range within) {
  return clip(ray, ellipse, within, {0, 0});
}

HitInterval clip_edge(const Segment& edge, const Ellipse& ellipse, Range within) {
  return clip({edge.a, edge.b}, ellipse, within, edge.a);
}

HitInterval clip_circle(const Ray& ray, const Circle& circle, Range within) {
  return clip_ellipse(ray, circle, within);
}

}  // namespace flatray
