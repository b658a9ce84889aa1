#include <algorithm>

#include "geom/clip_range.h"
#include "geom/hit_time.h"
#include "render/view.h"

namespace flatray::views_of {
namespace {

// Whether a rim the point lies on stands between it and the tip of the ray: the ray goes into the
// disc and leaves it before.
bool leaves_before_tip(const Ray& ray, const Circle& rim) {
  if (is_zero(ray.direction)) return false;
  const auto hit = hit_circle(ray, rim);
  return hit && hit->second.sign() == Sign::positive && hit->second.compare(1) < 0;
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
    const bool shadow =
        (hits[i] && hits[i].t < 1) ||
        std::any_of(context.rims.begin(), context.rims.end(),
                    [&](const Circle& rim) { return leaves_before_tip(rays.ray(i), rim); });
    pixels = std::fill_n(pixels, 3, shadow ? kShadow : kLit);
  }
}

}  // namespace

extern const View visibility = {
    "visibility", "what a point at x,y lights; one on a wall, both its sides", true, &draw_row};

}  // namespace flatray::views_of
