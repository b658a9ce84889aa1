#pragma once
#include <cmath>

#include "transport/moving_orbit.h"

namespace flatray {

/// Mirrors that move, one after the other.
struct MovingRoom : MovingWalls {
  MovingRoom() : MovingWalls{{}, {{Leg{}}}, {}, {kInfinity}} {}

  template <class Wall>
  void add(const Wall& wall, const std::vector<Leg>& legs, Material material = Material::mirror) {
    motion_of.push_back(static_cast<std::uint32_t>(motions.size()));
    motions.push_back(legs);
    gone_from.push_back(kInfinity);
    world.add(wall, {SurfaceOwner::Kind::chamber, 0, 0, static_cast<std::int32_t>(motion_of.size()),
                     material});
  }
  template <class Wall>
  void add(const Wall& wall, const Vec2& velocity = {0, 0}) {
    add(wall, {{0, kInfinity, {0, 0}, {0, 0}, velocity}});
  }
  void add_ring(const std::vector<Vec2>& vertices, const Vec2& velocity = {0, 0}) {
    for (std::size_t i = 0; i < vertices.size(); ++i)
      add(Segment{vertices[i], vertices[(i + 1) % vertices.size()]}, velocity);
  }
};

/// The same room, and all that is in it, seen by who flies past at -u.
inline MovingRoom drifting(MovingRoom room, const Vec2& u) {
  for (std::vector<Leg>& legs : room.motions)
    for (Leg& leg : legs) {
      leg.from += leg.begin * u;
      leg.velocity += u;
      if (!leg.is_last()) leg.to += leg.end * u;
    }
  return room;
}

/// Where a wall's origin is.
inline Vec2 place_of(const std::vector<Leg>& legs, double time) {
  for (const Leg& leg : legs)
    if (time < leg.end)
      return leg.from +
             (time - leg.begin) *
                 (leg.is_last() ? leg.velocity : Vec2((leg.to - leg.from) / (leg.end - leg.begin)));
  return legs.back().from;
}

/// To and fro between two x, from one key to the next.
inline std::vector<Leg> zigzag(double near, double far, double period, int count) {
  std::vector<Leg> legs;
  for (int i = 0; i < count; ++i) {
    const Vec2 from(i % 2 == 0 ? far : near, 0), to(i % 2 == 0 ? near : far, 0);
    legs.push_back({i * period, (i + 1) * period, from, to, {0, 0}});
  }
  legs.push_back({count * period, kInfinity, legs.back().to, {0, 0}, {0, 0}});
  return legs;
}

}  // namespace flatray
