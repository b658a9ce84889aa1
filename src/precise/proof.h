#pragma once
#include "precise/flight.h"
#include "precise/proven_bounces.h"

namespace flatray {

/// How far an arithmetic proves an orbit.
struct Proof {
  Proven proven;
  /// At the orbit's end, or where the exact one goes elsewhere: more bits tell no more.
  bool ended;
};

/// Whether what lies ahead is how the orbit ends.
inline bool is_end(const Prospect& next, const Orbit& orbit) {
  if (orbit.end == OrbitEnd::escape) return next.kind == Prospect::Kind::escape;
  if (orbit.end == OrbitEnd::absorbed || orbit.end == OrbitEnd::corner)
    return next.kind != Prospect::Kind::escape && next.walls == orbit.end_surfaces;
  return orbit.end == OrbitEnd::limit;
}

/// The orbit followed in numbers that make(double) gives, as Flight has them.
template <class Number, class Make>
Proof prove(const Surfaces& walls, const PeriodicWalls& periodic, const Orbit& orbit,
            const Make& make) {
  Flight<Number, Make> flight(walls, periodic, {orbit.start, orbit.direction}, make);
  auto crossing = orbit.crossings.begin();
  const std::size_t bounces = orbit.bounces.size();
  for (std::uint64_t proven = 0;; ++proven) {
    if (proven == bounces && orbit.end == OrbitEnd::limit) return {{bounces, true}, true};
    Prospect next = flight.next();
    const auto crossed = [&] {
      return crossing != orbit.crossings.end() && crossing->bounces == proven;
    };
    for (; flight.crosses(next); next = flight.next(), ++crossing) {
      if (!crossed()) return {{proven, false}, true};
      CellIndex cell = flight.cell();
      if (!flight.cross_over(next)) return {{proven, false}, false};
      cell += crossing->step;
      if (cell != flight.cell()) return {{proven, false}, true};
      if (flight.circles())
        return {{proven, proven == bounces && crossing + 1 == orbit.crossings.end() &&
                             orbit.end == OrbitEnd::escape},
                true};
    }
    if (next.kind == Prospect::Kind::open) return {{proven, false}, false};
    if (crossed()) return {{proven, false}, true};
    if (proven == bounces) return {{proven, is_end(next, orbit)}, true};
    const std::uint32_t wall = orbit.bounces[proven].surface;
    const bool same = next.kind == Prospect::Kind::wall && next.walls.front() == wall;
    if (!same) return {{proven, false}, true};
    if (!flight.bounce(wall)) return {{proven + 1, false}, false};
  }
}

}  // namespace flatray
