#include "precise/certified_orbit.h"

#ifdef FLATRAY_HAVE_MPFR
#include "precise/ball.h"
#include "precise/flight.h"
#endif

namespace flatray {

#ifdef FLATRAY_HAVE_MPFR
namespace {

constexpr unsigned kFirstBits = 128;

struct MakeBall {
  int bits;
  Ball operator()(double x) const { return {x, bits}; }
};
using BallFlight = Flight<Ball, MakeBall>;

std::optional<Vec2> rounded(const Pair<Ball>& point) {
  const auto x = point.x.nearest(), y = point.y.nearest();
  return x && y ? std::optional(Vec2(*x, *y)) : std::nullopt;
}

// The direction at length 1.
std::optional<Vec2> rounded_out(const BallFlight& flight) {
  const Ball length = square_root(flight.size());
  return rounded({flight.direction().x / length, flight.direction().y / length});
}

// The orbit as far as `bits` tell it.
class Follower {
 public:
  Follower(const Surfaces& walls, const Ray& start, unsigned bits)
      : flight_(walls, start, MakeBall{static_cast<int>(bits)}) {
    orbit_.bits = bits;
  }

  CertifiedOrbit follow(std::uint64_t bounces) {
    while (orbit_.decided && orbit_.end == OrbitEnd::limit && orbit_.bounces.size() < bounces)
      orbit_.decided = step();
    return std::move(orbit_);
  }

 private:
  bool step() {
    Prospect next = flight_.next();
    switch (next.kind) {
      case Prospect::Kind::open:
        return false;
      case Prospect::Kind::escape:
        return finish(OrbitEnd::escape, rounded_out(flight_), orbit_.out);
      case Prospect::Kind::corner:
        orbit_.corner_walls = next.walls;
        return flight_.bounce(next.walls.front()) &&
               finish(OrbitEnd::corner, rounded(flight_.point()), orbit_.corner);
      case Prospect::Kind::wall:
        break;
    }
    if (!flight_.bounce(next.walls.front())) return false;
    const auto point = rounded(flight_.point());
    if (point) orbit_.bounces.push_back({next.walls.front(), *point});
    return point.has_value();
  }

  bool finish(OrbitEnd end, const std::optional<Vec2>& value, Vec2& out) {
    if (!value) return false;
    orbit_.end = end;
    out = *value;
    return true;
  }

  BallFlight flight_;
  CertifiedOrbit orbit_;
};

}  // namespace

Result<CertifiedOrbit> certified_orbit(const Surfaces& walls, const Ray& start,
                                       std::uint64_t bounces, unsigned most_bits) {
  const std::vector<Material> mirrors(walls.size(), Material::mirror);
  const Orbit at_start = trace_orbit(walls, mirrors, start, 0);
  if (at_start.end != OrbitEnd::limit) {
    CertifiedOrbit stays;
    stays.end = at_start.end;
    stays.corner = at_start.end_point;
    stays.corner_walls = at_start.end_surfaces;
    return stays;
  }
  for (unsigned bits = kFirstBits;; bits = std::min(2 * bits, most_bits)) {
    CertifiedOrbit orbit = Follower(walls, start, bits).follow(bounces);
    if (orbit.decided || bits >= most_bits) return orbit;
  }
}
#else
Result<CertifiedOrbit> certified_orbit(const Surfaces&, const Ray&, std::uint64_t, unsigned) {
  return fail(named_place("certified orbits"), "this build has no MPFR",
              "install it (tools/setup does) and configure again", Trouble::unavailable);
}
#endif

}  // namespace flatray
