#include <algorithm>

#include "geom/clip_range.h"
#include "geom/exact_hit.h"
#include "geom/hit_time.h"
#include "render/view.h"

namespace flatray::views_of {
namespace {

// Whether a curve the point lies on stands between it and the tip of the ray: the ray goes in and
// leaves by it before.
bool leaves_before_tip(const Ray& ray, const Arc& rim) {
  if (is_zero(ray.direction)) return false;
  const auto hit = hit_curve(ray, rim.curve);
  return hit && hit->second.sign() == Sign::positive && hit->second.compare(1) < 0 &&
         (rim.extent == Arc::Extent::whole ||
          ExactHit(ray, rim.curve, HitTime::Root::second).place_in(rim) != ArcPlace::outside);
}

// Rays start at the point itself: the walls it lies on are told exactly, and hide nothing, as they
// are thin. What ends on a wall is lit.
void draw_row(const ViewContext& context, int row, std::uint8_t* pixels) {
  RayBatch rays;
  for (int i = 0; i < context.crop.width; ++i)
    rays.add({context.argument, pixel_centre(context, context.crop.x + i, row) - context.argument});
  const std::vector<NearestHit> hits = nearest_hits(context, rays);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    constexpr std::uint8_t kShadow = 64, kLit = 255;
    const bool shadow = (hits[i] && hits[i].t < 1) ||
                        std::any_of(context.rims.begin(), context.rims.end(), [&](const Arc& rim) {
                          return leaves_before_tip(rays.ray(i), rim);
                        });
    pixels = std::fill_n(pixels, 3, shadow ? kShadow : kLit);
  }
}

}  // namespace

extern const View visibility = {
    "visibility", "what a point at x,y lights; one on a wall, both its sides", true, &draw_row};

}  // namespace flatray::views_of
