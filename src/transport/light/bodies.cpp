#include "transport/light/bodies.h"

namespace flatray {

Bodies::Bodies(const World& world, std::span<const Scatterer* const> scatterers)
    : walls_(world.surfaces), bodies_(scatterers.size(), Media::kNone) {
  const SurfaceOwner* last = nullptr;  // surfaces of one owner follow one another
  for (std::size_t i = 0; i < scatterers.size(); ++i) {
    if (scatterers[i] == nullptr || scatterers[i]->index(0) == 0) continue;
    const SurfaceOwner& owner = world.owners[i];
    if (last == nullptr || owner.kind != last->kind || owner.index != last->index ||
        owner.pillar != last->pillar)
      scatterers_.push_back(scatterers[i]);
    last = &owner;
    bodies_[i] = static_cast<std::uint32_t>(scatterers_.size() - 1);
    disperse_ |= scatterers[i]->disperses();
  }
}

Media Bodies::around_start(const Ray& ray, std::span<const NearestHit> hits) const {
  std::vector<std::uint32_t> inside;  // the innermost first
  std::vector<char> seen(scatterers_.size());
  for (const NearestHit& hit : hits) {
    const std::uint32_t body = of(hit.surface);
    if (body == Media::kNone || hit.at_end || hit.kind == HitClass::along || seen[body] != 0)
      continue;
    seen[body] = 1;
    if (from_inside(walls_, ray, hit)) inside.push_back(body);
  }
  Media media;
  for (auto body = inside.rbegin(); body != inside.rend(); ++body) media.enter(*body);
  return media;
}

bool from_inside(const Surfaces& walls, const Ray& ray, const NearestHit& hit) {
  const Sign inside = walls.is_straight(hit.surface) ? Sign::positive : Sign::negative;
  return inner_side(walls, ray, hit) == inside;
}

bool goes_inside(const Surfaces& walls, const Left& left, const Vec2& direction) {
  if (!walls.is_straight(left.surface)) return left.root == Root::first;
  const Segment& wall = walls.segments[walls.slot[left.surface]];
  return turn_from_edge(wall.a, wall.b, direction) == Sign::positive;
}

}  // namespace flatray
