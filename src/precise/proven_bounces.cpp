#include "precise/proven_bounces.h"

#include "base/check.h"
#include "geom/bounded.h"
#include "precise/flight.h"
#ifdef FLATRAY_HAVE_MPFR
#include "precise/ball.h"
#endif

namespace flatray {
namespace {

struct Proof {
  Proven proven;
  bool ended;  // at the orbit's end, or where the exact one goes elsewhere: more bits tell no more
};

// Whether what lies ahead is how the orbit ends.
bool is_end(const Prospect& next, const Orbit& orbit) {
  switch (orbit.end) {
    case OrbitEnd::limit:
      return true;
    case OrbitEnd::escape:
      return next.kind == Prospect::Kind::escape;
    case OrbitEnd::absorbed:
    case OrbitEnd::corner:
      return next.kind != Prospect::Kind::escape && next.walls == orbit.end_surfaces;
    case OrbitEnd::along:
      return false;
  }
  unreachable();
}

template <class Number, class Make>
Proof prove(const Surfaces& walls, const Orbit& orbit, const Make& make) {
  Flight<Number, Make> flight(walls, {orbit.start, orbit.direction}, make);
  const std::size_t bounces = orbit.bounces.size();
  // The first hit was decided without rounding.
  std::uint64_t proven = 1;
  for (; proven <= bounces; ++proven) {
    if (!flight.bounce(orbit.bounces[proven - 1].surface)) return {{proven, false}, false};
    if (proven == bounces && orbit.end == OrbitEnd::limit) break;
    const Prospect next = flight.next();
    if (next.kind == Prospect::Kind::open) return {{proven, false}, false};
    if (proven == bounces) return {{proven, is_end(next, orbit)}, true};
    const bool same =
        next.kind == Prospect::Kind::wall && next.walls.front() == orbit.bounces[proven].surface;
    if (!same) return {{proven, false}, true};
  }
  return {{bounces, true}, true};
}

}  // namespace

Proven proven_bounces(const Surfaces& walls, const Orbit& orbit) {
  if (orbit.bounces.empty()) return {0, true};  // decided without rounding
  Proof proof = prove<Bounded>(walls, orbit, [](double x) { return Bounded(x); });
#ifdef FLATRAY_HAVE_MPFR
  constexpr int kFirstBits = 256, kLastBits = 2048;
  for (int bits = kFirstBits; !proof.ended && bits <= kLastBits; bits *= 2)
    proof = prove<Ball>(walls, orbit, [bits](double x) { return Ball(x, bits); });
#endif
  return proof.proven;
}

}  // namespace flatray
