#include "geom/clip_range.h"
#include "geom/cyrus_beck.h"
#include "geom/decide.h"

namespace flatray {
namespace {

StartPlace place_in_disc(const Vec2& point, const Circle& circle) {
  const Sign outside = decide([&](const auto& number) {
    const auto x = number(point.x()) - number(circle.centre.x());
    const auto y = number(point.y()) - number(circle.centre.y());
    return x * x + y * y - number(circle.radius) * number(circle.radius);
  });
  return outside == Sign::positive ? StartPlace::outside
         : outside == Sign::zero   ? StartPlace::boundary
                                   : StartPlace::inside;
}

}  // namespace

HitInterval clip_circle(const Ray& ray, const Circle& circle, Range within) {
  if (is_zero(ray.direction)) return point_test(place_in_disc(ray.origin, circle), within);
  const auto line = hit_circle(ray, circle);
  if (!line) return {};
  // A disc has no straight boundary to run along.
  const HitClass kind = line->tangent ? HitClass::touch : HitClass::through;
  return clip_to_range({line->first, line->second, kNoEdge, kNoEdge, kind}, within);
}

}  // namespace flatray
