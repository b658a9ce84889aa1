#include "transport/periodic_walls.h"

#include <algorithm>

#include "base/check.h"

namespace flatray {

PeriodicWalls::PeriodicWalls(const Surfaces& walls, std::span<const Material> materials) {
  if (materials.empty()) return;
  Bounds box;
  for (std::uint32_t i = 0; i < walls.size(); ++i) {
    if (materials[i] != Material::periodic) continue;
    FLATRAY_CHECK(walls.segment_slot(i) != kNoSurface);
    box.add(bounds_of(walls.segment(i)));
    sides_.push_back({i, i, 0, 0, 0, 0});
  }
  for (Side& side : sides_) {
    const Segment& wall = walls.segment(side.surface);
    side.axis = wall.a.x() == wall.b.x() ? 0 : 1;
    const double place = wall.a[side.axis];
    const bool low = place == box.low[side.axis];
    FLATRAY_CHECK(place == wall.b[side.axis] && (low || place == box.high[side.axis]));
    side.out = low ? -1 : 1;
    side.near = place;
    side.far = low ? box.high[side.axis] : box.low[side.axis];
  }
  for (Side& side : sides_)
    for (const Side& other : sides_)
      if (other.axis == side.axis && other.out != side.out) side.opposite = other.surface;
}

const PeriodicWalls::Side* PeriodicWalls::find(std::uint32_t surface) const {
  const auto side = std::find_if(sides_.begin(), sides_.end(),
                                 [&](const Side& one) { return one.surface == surface; });
  return side == sides_.end() ? nullptr : &*side;
}

bool PeriodicWalls::leads_out(std::uint32_t surface, const Vec2& direction) const {
  const Side* side = find(surface);
  return side != nullptr && side->out * direction[side->axis] > 0;
}

std::optional<PeriodicWalls::Entry> PeriodicWalls::cross(
    const Vec2& point, const Vec2& direction, std::span<const std::uint32_t> surfaces) const {
  std::optional<Entry> entry;
  for (const std::uint32_t surface : surfaces) {
    if (!leads_out(surface, direction)) continue;
    const Side& side = *find(surface);
    if (!entry) entry = Entry{point, surface};
    entry->point[side.axis] = side.far;
    entry->surface = side.opposite;
  }
  return entry;
}

}  // namespace flatray
