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
          ExactHit(ray, rim.curve, Root::second).place_in(rim) != PlaceOn::outside);
}

void keep_rim(const Segment&, const std::vector<Arc>&) {}
void keep_rim(const Arc& wall, std::vector<Arc>& rims) { rims.push_back(wall); }

// What is left of a world without the walls a point lies on.
World without_walls_at(const Vec2& point, const World& all, std::vector<Arc>& rims) {
  World rest;
  for (std::uint32_t number = 0; number < all.surfaces.size(); ++number) {
    all.surfaces.visit(number, [&](const auto& wall) {
      if (place_on(wall, point) == PlaceOn::outside)
        rest.add(wall, all.owner(number));
      else
        keep_rim(wall, rims);
    });
  }
  return rest;
}

class Visibility : public ViewRows {
 public:
  explicit Visibility(const ViewFrame& frame)
      : frame_(frame),
        seen_(frame, without_walls_at(frame.argument,
                                      build_world(frame.scene, frame.state, WorldOf::everything),
                                      rims_)) {}

  // Rays start at the point itself: the walls it lies on are told exactly, and hide nothing, as they
  // are thin. What ends on a wall is lit.
  void draw(int row, std::uint8_t* pixels) const override {
    RayBatch rays;
    for (int i = 0; i < frame_.crop.width; ++i)
      rays.add({frame_.argument, pixel_centre(frame_, frame_.crop.x + i, row) - frame_.argument});
    const std::vector<NearestHit> hits = seen_.nearest(rays);
    for (std::size_t i = 0; i < hits.size(); ++i) {
      constexpr std::uint8_t kShadow = 64, kLit = 255;
      const bool shadow = (hits[i] && hits[i].t < 1) ||
                          std::any_of(rims_.begin(), rims_.end(), [&](const Arc& rim) {
                            return leaves_before_tip(rays.ray(i), rim);
                          });
      pixels = std::fill_n(pixels, 3, shadow ? kShadow : kLit);
    }
  }

 private:
  const ViewFrame frame_;
  std::vector<Arc> rims_;  // circles that the point lies on; its segments are nowhere
  const SeenWalls seen_;
};

}  // namespace

extern const View visibility = {"visibility",
                                "what a point at x,y lights; one on a wall, both its sides", true,
                                false, &make_rows<Visibility>};

}  // namespace flatray::views_of
