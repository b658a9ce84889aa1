#include "transport/glass.h"

#include "base/philox.h"

namespace flatray {

Glass::Glass(const Scene& scene, const World& world)
    : walls_(world.surfaces),
      scatterers_(scatterers_of(scene, world)),
      bodies_(world, scatterers_) {}

bool Glass::is_inside(std::uint32_t surface, Sign side) const {
  return walls_.visit(surface, [](const auto& wall) { return inside_of(wall); }) == side;
}

std::optional<Vec2> Glass::refracted(const GlassHit& meeting, Media& media, double chance) const {
  const std::uint32_t body = bodies_.of(meeting.surface);
  const bool from_inside = is_inside(meeting.surface, meeting.side);
  const Departure departure = scatterers_[meeting.surface]->scatter(
      {meeting.direction, meeting.normal, from_inside, bodies_.index_around(media, body, 0)},
      chance);
  if (departure.way != Departure::Way::scattered) return std::nullopt;
  media.leave(body);
  if (!from_inside) media.enter(body);
  return departure.direction;
}

std::array<double, 2> Glass::indices(std::uint32_t surface) const {
  const std::uint32_t body = bodies_.of(surface);
  if (body == Media::kNone) return {1, 1};
  const double own = bodies_.index_in(body, 0);
  if (is_inside(surface, Sign::positive)) return {own, 1};
  return {1, own};
}

std::uint64_t chance_of_orbit(std::uint64_t seed, std::uint64_t number) {
  return random_bits(seed, Stream::split, number >> 32, number);
}

}  // namespace flatray
