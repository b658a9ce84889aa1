#include "precise/proven_bounces.h"

#include "geom/bounded.h"
#include "precise/flight.h"
#ifdef FLATRAY_HAVE_MPFR
#include "precise/ball.h"
#endif

namespace flatray {
namespace {

struct Proof {
  std::uint64_t bounces;
  bool ended;  // at the orbit's end, or where the exact one goes elsewhere: more bits tell no more
};

template <class Number, class Make>
Proof prove(const Surfaces& walls, const Orbit& orbit, const Make& make) {
  Flight<Number, Make> flight(walls, {orbit.start, orbit.direction}, make);
  // The first hit was decided without rounding.
  std::uint64_t proven = 1;
  for (; proven < orbit.bounces.size(); ++proven) {
    if (!flight.bounce(orbit.bounces[proven - 1].surface)) return {proven, false};
    const Prospect next = flight.next();
    if (next.kind == Prospect::Kind::open) return {proven, false};
    const bool same =
        next.kind == Prospect::Kind::wall && next.walls.front() == orbit.bounces[proven].surface;
    if (!same) return {proven, true};
  }
  return {proven, true};
}

}  // namespace

std::uint64_t proven_bounces(const Surfaces& walls, const Orbit& orbit) {
  if (orbit.bounces.empty()) return 0;
  Proof proof = prove<Bounded>(walls, orbit, [](double x) { return Bounded(x); });
#ifdef FLATRAY_HAVE_MPFR
  constexpr int kFirstBits = 256, kLastBits = 2048;
  for (int bits = kFirstBits; !proof.ended && bits <= kLastBits; bits *= 2)
    proof = prove<Ball>(walls, orbit, [bits](double x) { return Ball(x, bits); });
#endif
  return proof.bounces;
}

}  // namespace flatray
