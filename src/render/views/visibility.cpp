#include <algorithm>

#include "geom/clip_range.h"
#include "render/view.h"
#include "transport/exact_origin.h"

namespace flatray::visibility_view {
namespace {

// Whether a curve the point lies on stands between it and the tip of the ray, which crosses it again.
bool crosses_before_tip(const Ray& ray, const Surfaces& rims) {
  if (is_zero(ray.direction)) return false;
  std::vector<WallMeeting> met;
  for (std::uint32_t i = 0; i < rims.size(); ++i)
    rims.visit(i, [&](const auto& rim) { meet(rim, ray, {Root::none, false, true}, met); });
  return std::any_of(met.begin(), met.end(), [](const WallMeeting& one) {
    return one.kind == HitClass::through && one.time.sign() == Sign::positive &&
           one.time.compare(1) < 0;
  });
}

// What is left of a world without the walls a point lies on.
World without_walls_at(const Vec2& point, const World& all, Surfaces& rims) {
  World rest;
  for (std::uint32_t number = 0; number < all.surfaces.size(); ++number) {
    all.surfaces.visit(number, [&](const auto& wall) {
      if (place_on(wall, point) == PlaceOn::outside)
        rest.add(wall, all.owner(number));
      else
        rims.add(wall);
    });
  }
  return rest;
}

// Rays start at the point itself: the walls it lies on are told exactly, and hide nothing, as they
// are thin. What ends on a wall is lit. Where the point is so far away that rounding the way to a pixel
// moves its end, they start at the pixels.
void draw(const ViewFrame& frame, const EachRow& each_row) {
  const Vec2 point = frame.argument + frame.state.displaced;
  Surfaces rims;  // the walls that the point lies on
  const SeenWalls seen(
      frame,
      without_walls_at(point, build_world(frame.scene, frame.state, WorldOf::everything), rims));
  const bool is_far = point.cwiseAbs().maxCoeff() * 0x1p-52 >
                      0x1p-20 * (pixel_centre(frame, 1, 0) - pixel_centre(frame, 0, 0)).norm();
  each_row([&](int row, std::uint8_t* pixels) {
    RayBatch rays;
    for (int i = 0; i < frame.crop.width; ++i) {
      const Vec2 pixel = pixel_centre(frame, frame.crop.x + i, row);
      rays.add(is_far ? Ray{pixel, point - pixel} : Ray{point, pixel - point});
    }
    const std::vector<NearestHit> hits = seen.nearest(rays);
    for (std::size_t i = 0; i < hits.size(); ++i) {
      constexpr std::uint8_t kShadow = 64, kLit = 255;
      const Ray ray = rays.ray(i), from_point = is_far ? Ray{point, -ray.direction} : ray;
      const bool is_on_wall = is_far && hits[i] && hits[i].t == 0;
      const Vec2 tip =
          is_far ? point : pixel_centre(frame, frame.crop.x + static_cast<int>(i), row);
      const bool hidden = hits[i] && is_before(seen.surfaces(), ray, hits[i], tip);
      const bool shadow =
          (is_on_wall ? seen.crosses(ray) : hidden) || crosses_before_tip(from_point, rims);
      pixels = std::fill_n(pixels, 3, shadow ? kShadow : kLit);
    }
  });
}

}  // namespace

extern const View entry = {
    "visibility", "what a point at x,y lights; one on a wall, both its sides", true, false, &draw};

}  // namespace flatray::visibility_view
