#include "transport/light/bodies.h"

#include <algorithm>

#include "base/portable_math.h"

namespace flatray {

Bodies::Bodies(const World& world, std::span<const Scatterer* const> scatterers)
    : walls_(world.surfaces), bodies_(scatterers.size(), Media::kNone) {
  const SurfaceOwner* last = nullptr;  // surfaces of one owner follow one another
  for (std::size_t i = 0; i < scatterers.size(); ++i) {
    if (scatterers[i] == nullptr || scatterers[i]->index(0) == 0) continue;
    const SurfaceOwner& owner = world.owners[i];
    if (last == nullptr || owner.kind != last->kind || owner.index != last->index ||
        owner.pillar != last->pillar)
      scatterers_.push_back(scatterers[i]), absorptions_.push_back(scatterers[i]->absorption());
    last = &owner;
    bodies_[i] = static_cast<std::uint32_t>(scatterers_.size() - 1);
    disperse_ |= scatterers[i]->disperses();
    absorb_ |= absorptions_.back() != std::array<double, 3>{0, 0, 0};
    surfaces_.resize(scatterers_.size());
    surfaces_.back().push_back(static_cast<std::uint32_t>(i));
  }
  for (std::uint32_t body = 0; body < surfaces_.size(); ++body) {
    Bounds& box = bounds_.emplace_back();
    for (const std::uint32_t surface : surfaces_[body])
      box.add(walls_.visit(surface, [](const auto& wall) { return bounds_of(wall); }));
    outermost_first_.push_back(body);
  }
  const auto reach = [&](std::uint32_t body) { return bounds_[body].size().sum(); };
  std::ranges::stable_sort(outermost_first_, std::ranges::greater(), reach);
}

// By the crossings of the half line to the right.
bool Bodies::holds(std::uint32_t body, const Vec2& point) const {
  if (!bounds_[body].contains(point)) return false;
  bool inside = false;
  for (const std::uint32_t surface : surfaces_[body]) {
    const bool on_it = walls_.visit(surface, [&](const auto& wall) {
      inside ^= crosses_to_right(wall, point);
      return place_on(wall, point) != PlaceOn::outside;
    });
    if (on_it) return false;
  }
  return inside;
}

std::array<double, 3> Bodies::left_after(double length, const Media& media) const {
  if (!absorb_) return {1, 1, 1};
  const std::array<double, 3>& absorption = absorption_in(media);
  return {fading(absorption[0], length).left, fading(absorption[1], length).left,
          fading(absorption[2], length).left};
}

Media Bodies::around(const Vec2& point) const {
  Media media;
  for (const std::uint32_t body : outermost_first_)
    if (holds(body, point)) media.enter(body);
  return media;
}

Fading fading(double absorption, double length) {
  const double depth = absorption * length;
  if (!(depth > 0)) return {1, 1};
  const double left = portable::exp(-depth);
  // Of little the difference from 1 is: (1 - exp(-x)) / x by its series, whose next term is x^4 / 120.
  const double series = 1 - depth / 2 * (1 - depth / 3 * (1 - depth / 4));
  return {left, depth < 0x1p-10 ? series : (1 - left) / depth};
}

bool goes_inside(const Surfaces& walls, const DepartedSurface& departed, const Vec2& direction) {
  return walls.visit(departed.surface, [&](const auto& wall) {
    return -side_met(wall, {{0, 0}, direction}, departed.root) == inside_of(wall);
  });
}

}  // namespace flatray
