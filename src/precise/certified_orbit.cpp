#include "precise/certified_orbit.h"

#include <algorithm>

#ifdef FLATRAY_HAVE_MPFR
#include "precise/ball.h"
#include "precise/flight.h"
#endif

namespace flatray {

#ifdef FLATRAY_HAVE_MPFR
namespace {

constexpr unsigned kFirstBits = 128;

std::uint64_t work_for(unsigned most_bits) {
  constexpr std::uint64_t kMostWork = std::uint64_t{1} << 32;
  return kMostWork / kMostBits * std::max(most_bits, kMostBits);
}

struct MakeBall {
  int bits;
  Ball operator()(double x) const { return {x, bits}; }
};
using BallFlight = Flight<Ball, MakeBall>;

std::optional<Vec2> rounded(const Pair<Ball>& point, double scale) {
  const auto x = point.x.nearest_or_even(scale), y = point.y.nearest_or_even(scale);
  return x && y ? std::optional(Vec2(*x, *y)) : std::nullopt;
}

// The direction at length 1.
std::optional<Vec2> rounded_out(const BallFlight& flight) {
  const Ball length = square_root(flight.size());
  return rounded({flight.direction().x / length, flight.direction().y / length}, 1);
}

double largest_coordinate(const Surfaces& walls) {
  double largest = 0;
  const auto see = [&](const Vec2& point, double reach) {
    largest = std::max(largest, point.cwiseAbs().maxCoeff() + reach);
  };
  for (const Segment& wall : walls.segments) {
    see(wall.a, 0);
    see(wall.b, 0);
  }
  for (const Circle& wall : walls.circles) see(wall.centre, wall.radius);
  return std::min(largest, std::numeric_limits<double>::max());
}

// The orbit as far as `bits` tell it.
class Follower {
 public:
  Follower(const Surfaces& walls, const Ray& start, unsigned bits)
      : flight_(walls, start, MakeBall{static_cast<int>(bits)}),
        scale_(largest_coordinate(walls)),
        work_of_step_(std::uint64_t{bits} * (walls.size() + 1)) {
    orbit_.bits = bits;
  }

  // Takes what it does from `work`, and is undecided where none is left.
  CertifiedOrbit follow(std::uint64_t bounces, std::uint64_t& work) {
    while (orbit_.decided && orbit_.end == OrbitEnd::limit && orbit_.bounces.size() < bounces) {
      orbit_.decided = work >= work_of_step_ && step();
      work -= std::min(work, work_of_step_);
    }
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
      case Prospect::Kind::corner: {
        const auto corner = flight_.corner_at(next.walls.front());
        if (!corner) return false;
        orbit_.corner_walls = std::move(next.walls);
        return finish(OrbitEnd::corner, rounded(*corner, scale_), orbit_.corner);
      }
      case Prospect::Kind::wall:
        break;
    }
    if (!flight_.bounce(next.walls.front())) return false;
    const auto point = rounded(flight_.point(), scale_);
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
  double scale_;
  std::uint64_t work_of_step_;
  CertifiedOrbit orbit_;
};

}  // namespace

Result<CertifiedOrbit> certified_orbit(const Surfaces& walls, const Ray& start,
                                       std::uint64_t bounces, unsigned most_bits,
                                       std::optional<std::uint64_t> most_work) {
  const std::vector<Material> mirrors(walls.size(), Material::mirror);
  const Orbit at_start = trace_orbit(walls, mirrors, start, 0);
  if (at_start.end != OrbitEnd::limit) {
    CertifiedOrbit stays;
    stays.end = at_start.end;
    stays.corner = at_start.end_point;
    stays.corner_walls = at_start.end_surfaces;
    return stays;
  }
  std::uint64_t work = most_work.value_or(work_for(most_bits));
  CertifiedOrbit best;
  for (unsigned bits = kFirstBits;; bits = std::min(2 * bits, most_bits)) {
    CertifiedOrbit orbit = Follower(walls, start, bits).follow(bounces, work);
    const bool last = orbit.decided || bits >= most_bits || work == 0;
    if (orbit.decided || orbit.bounces.size() >= best.bounces.size()) best = std::move(orbit);
    if (last) return best;
  }
}

Result<void> can_certify() { return {}; }
#else
Result<void> can_certify() {
  return fail(named_place("certified orbits"), "this build has no MPFR",
              "install it (tools/setup does) and configure again", Trouble::unavailable);
}

Result<CertifiedOrbit> certified_orbit(const Surfaces&, const Ray&, std::uint64_t, unsigned,
                                       std::optional<std::uint64_t>) {
  return tl::unexpected(can_certify().error());
}
#endif

}  // namespace flatray
