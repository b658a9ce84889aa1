#include <array>

#include "render/view.h"

namespace flatray::hits_view {
namespace {

// A colour for each object: the hue goes round by the golden ratio, so that neighbours differ.
std::array<std::uint8_t, 3> colour_of(std::uint32_t object) {
  constexpr double kGolden = 0.6180339887498949;
  const double turns = kGolden * object, hue = 6 * (turns - std::floor(turns));
  std::array<std::uint8_t, 3> rgb{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double away = std::fabs(std::fmod(hue + 6 - 2 * static_cast<double>(i), 6.0) - 3);
    rgb[i] = static_cast<std::uint8_t>(40 + 200 * std::clamp(away - 1, 0.0, 1.0));
  }
  return rgb;
}

// Entities first, then chambers and their pillars.
std::uint32_t object_of(const Scene& scene, const SurfaceOwner& owner) {
  if (owner.kind == SurfaceOwner::Kind::entity) return owner.index;
  auto number = static_cast<std::uint32_t>(scene.entities.size());
  for (std::uint32_t i = 0; i < owner.index; ++i)
    number += 1 + static_cast<std::uint32_t>(scene.chambers[i].pillars.size());
  return owner.kind == SurfaceOwner::Kind::pillar ? number + 1 + owner.pillar : number;
}

void draw(const ViewFrame& frame, const EachRow& each_row) {
  const SeenWalls seen(frame);
  each_row([&](int row, std::uint8_t* pixels) {
    for (const NearestHit& hit : seen.nearest(rays_to_the_right(frame, row))) {
      constexpr std::array<std::uint8_t, 3> kNothing{255, 255, 255};
      const auto rgb = hit ? colour_of(object_of(frame.scene, seen.owner(hit))) : kNothing;
      pixels = std::copy(rgb.begin(), rgb.end(), pixels);
    }
  });
}

}  // namespace

extern const View entry = {"hits", "the nearest object to the right of each pixel, by colour",
                           false, false, &draw};

}  // namespace flatray::hits_view
