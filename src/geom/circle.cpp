#include "geom/clip.h"
#include "geom/clip_range.h"

namespace flatray {

HitInterval clip_ellipse(const Ray& ray, const Ellipse& ellipse, Range within) {
  if (is_zero(ray.direction)) {
    const Sign side = curve_side(ray.origin, ellipse);
    return point_test(side == Sign::positive ? StartPlace::outside
                      : side == Sign::zero   ? StartPlace::boundary
                                             : StartPlace::inside,
                      within);
  }
  const auto line = hit_curve(ray, ellipse);
  if (!line) return {};
  // There is no straight boundary to run along.
  const HitClass kind = line->tangent ? HitClass::touch : HitClass::through;
  return clip_to_range({line->first, line->second, kNoEdge, kNoEdge, kind}, within);
}

HitInterval clip_circle(const Ray& ray, const Circle& circle, Range within) {
  return clip_ellipse(ray, circle, within);
}

}  // namespace flatray
