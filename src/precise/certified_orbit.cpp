// Part of the module flatray_certified.so.
#include "precise/certified_orbit.h"

#include <algorithm>
#include <limits>

#include "base/check.h"
#include "precise/ball.h"
#include "precise/certain.h"
#include "precise/flight.h"
#include "precise/module.h"

namespace flatray {
namespace {

constexpr unsigned kFirstBits = 128;
constexpr unsigned kLongest = 16;  // numbers without error, in parts of the bits of balls

std::uint64_t work_for(unsigned most_bits) {
  constexpr std::uint64_t kMostWork = std::uint64_t{1} << 32;
  return kMostWork / kMostBits * std::max(most_bits, kMostBits);
}

template <class Number>
struct MakeOf {
  int bits;
  Number operator()(double x) const { return {x, bits}; }
};
template <class Number>
using FlightIn = Flight<Number, MakeOf<Number>>;

template <class Number>
std::optional<Vec2> rounded(const Pair<Number>& point) {
  const auto x = point.x.nearest(), y = point.y.nearest();
  return x && y ? std::optional(Vec2(*x, *y)) : std::nullopt;
}

// A direction at length 1, of which the square of the length is given.
std::optional<Vec2> rounded_out(const Pair<Ball>& direction, const Ball& size) {
  const Ball length = square_root(size);
  return rounded(Pair<Ball>{direction.x / length, direction.y / length});
}
// By squares, of which more are rational than of roots.
std::optional<double> rounded_share(const Certain& x, const Certain& size) {
  const Certain share = x * x / size;
  if (const Rational* square = share.rational())
    if (const auto sign = x.sign()) return Rational::root_sum(0, static_cast<int>(*sign), *square);
  return (x.ball() / square_root(size.ball())).nearest();
}
std::optional<Vec2> rounded_out(const Pair<Certain>& direction, const Certain& size) {
  const auto x = rounded_share(direction.x, size), y = rounded_share(direction.y, size);
  return x && y ? std::optional(Vec2(*x, *y)) : std::nullopt;
}

// Bits that the numbers of a flight hold, and what a wall costs then, counted in bits of balls: long
// fractions are reduced.
unsigned bits_of(const FlightIn<Ball>&, unsigned working) { return working; }
unsigned bits_of(const FlightIn<Certain>& flight, unsigned) {
  std::size_t most = 0;
  for (const Certain* x : {&flight.moment(), &flight.direction().x, &flight.direction().y,
                           &flight.point().x, &flight.point().y})
    most = std::max(most, x->bits());
  return static_cast<unsigned>(most);
}
std::uint64_t cost_of(const FlightIn<Ball>&, unsigned bits) { return bits; }
std::uint64_t cost_of(const FlightIn<Certain>&, unsigned bits) {
  return bits + std::uint64_t{bits} * bits / 4096;
}

// Makes balls of numbers without error that have become too long.
void keep_short(FlightIn<Ball>&, unsigned) {}
void keep_short(FlightIn<Certain>& flight, unsigned longest) {
  if (bits_of(flight, 0) > longest) flight.blur();
}

// The orbit as far as an arithmetic tells it.
template <class Number>
class Follower {
 public:
  /// `bits` is the working precision of balls.
  Follower(const Surfaces& walls, const CertifiedRules& rules, const Ray& start, unsigned bits)
      : rules_(rules),
        make_{static_cast<int>(bits)},
        periodic_(walls, rules.materials),
        flight_(walls, periodic_, start, make_),
        flown_(make_(0)),
        walls_(walls.size() + 1),
        bits_(bits) {}

  // Takes what it does from `work`, and is undecided where none is left.
  CertifiedOrbit follow(std::uint64_t bounces, std::uint64_t& work) {
    while (orbit_.decided && orbit_.end == OrbitEnd::limit && orbit_.bounces.size() < bounces) {
      keep_short(flight_, std::min(kLongest * bits_, rules_.most_bits));
      const unsigned bits = bits_of(flight_, bits_);
      orbit_.bits = std::max(orbit_.bits, bits);
      const std::uint64_t cost = cost_of(flight_, bits) * walls_;
      orbit_.decided = bits <= rules_.most_bits && work >= cost && step();
      work -= std::min(work, cost);
    }
    return std::move(orbit_);
  }

 private:
  bool step() {
    const Prospect next = flight_.next();
    if (next.kind == Prospect::Kind::open) return false;
    if (next.kind == Prospect::Kind::escape)
      return finish(OrbitEnd::escape, rounded_out(flight_.direction(), flight_.size()), orbit_.out);
    if (flight_.crosses(next)) return cross(next);
    if (!rules_.materials.empty())
      if (auto takers = taken_by(rules_.materials, next.walls); !takers.empty())
        return stop(OrbitEnd::absorbed, std::move(takers));
    if (next.kind == Prospect::Kind::corner) return stop(OrbitEnd::corner, next.walls);
    return bounce(next.walls.front());
  }

  bool bounce(std::uint32_t wall) {
    const Pair<Number> from = flight_.point(), way = flight_.direction();
    if (!flight_.bounce(wall)) return false;
    fly(from, flight_.point(), way);
    Pair<Number> normal = flight_.normal(wall);
    const auto turned = dot(normal, flight_.direction()).sign();
    if (!turned || *turned == Sign::zero) return false;
    if (*turned == Sign::negative) normal = {-normal.x, -normal.y};
    const auto point = rounded(flight_.point());
    constexpr double kMost = std::numeric_limits<double>::max();
    const bool beyond = (flown_ - make_(kMost)).sign() == Sign::positive;
    const auto t = beyond ? kMost : flown_.nearest();
    const auto up = rounded_out(normal, dot(normal, normal));
    const auto in = rounded_out(way, flight_.size());
    const auto out = rounded_out(flight_.direction(), flight_.size());
    if (!point || !t || !up || !in || !out) return false;
    orbit_.bounces.push_back({wall, *point, *t, *up, *in, *out, flight_.cell()});
    flown_ = make_(0);
    return true;
  }

  // Adds the t of a straight way.
  void fly(const Pair<Number>& from, const Pair<Number>& to, const Pair<Number>& way) {
    flown_ = flown_ + dot(to - from, way) / flight_.size();
  }

  bool cross(const Prospect& next) {
    const Pair<Number> start = flight_.point();
    const CellIndex before = flight_.cell();
    const auto left = flight_.cross_over(next);
    if (!left) return false;
    const CellIndex step = flight_.cell() - before;
    fly(start, *left, flight_.direction());
    const auto from = rounded(*left), to = rounded(flight_.point());
    if (!from || !to) return false;
    orbit_.crossings.push_back({orbit_.bounces.size(), *from, *to, step});
    const auto t =
        flight_.cross_on(next, [&](const Vec2& out, const Vec2& in, const CellIndex& by) {
          orbit_.crossings.push_back({orbit_.bounces.size(), out, in, by});
        });
    if (!t) return false;
    flown_ = flown_ + *t;
    if (flight_.circles())
      return finish(OrbitEnd::escape, rounded_out(flight_.direction(), flight_.size()), orbit_.out);
    return true;
  }

  bool stop(OrbitEnd end, std::vector<std::uint32_t> walls) {
    const auto point = flight_.corner_at(walls.front());
    if (!point || !finish(end, rounded(*point), orbit_.end_point)) return false;
    orbit_.end_surfaces = std::move(walls);
    return true;
  }

  bool finish(OrbitEnd end, const std::optional<Vec2>& value, Vec2& out) {
    if (!value) return false;
    orbit_.end = end;
    out = *value;
    return true;
  }

  const CertifiedRules& rules_;
  const MakeOf<Number> make_;
  PeriodicWalls periodic_;
  FlightIn<Number> flight_;
  Number flown_;  // t since the last bounce
  std::size_t walls_;
  unsigned bits_;
  CertifiedOrbit orbit_;
};

}  // namespace

CertifiedOrbit certify(const Surfaces& walls, const Ray& start, std::uint64_t bounces,
                       const CertifiedRules& rules) {
  FLATRAY_CHECK(rules.materials.empty() || rules.materials.size() == walls.size());
  std::vector<Material> materials(rules.materials.begin(), rules.materials.end());
  materials.resize(walls.size(), Material::mirror);
  Orbit at_start = trace_orbit(walls, materials, start, 0);
  if (at_start.end != OrbitEnd::limit) {
    CertifiedOrbit stays;
    static_cast<OrbitStop&>(stays) = std::move(at_start);
    return stays;
  }
  std::uint64_t work = rules.most_work.value_or(work_for(rules.most_bits));
  CertifiedOrbit best;
  const auto keep = [&](CertifiedOrbit orbit) {
    const bool further = orbit.bounces.size() > best.bounces.size();
    if (orbit.decided || orbit.bounces.size() >= best.bounces.size()) best = std::move(orbit);
    return further;
  };
  for (unsigned bits = kFirstBits;; bits = std::min(2 * bits, rules.most_bits)) {
    const bool last = bits >= rules.most_bits;
    const bool further =
        !best.rational && keep(Follower<Ball>(walls, rules, start, bits).follow(bounces, work));
    if (!best.decided && (!further || last)) {
      CertifiedOrbit orbit = Follower<Certain>(walls, rules, start, bits).follow(bounces, work);
      orbit.rational = true;
      keep(std::move(orbit));
    }
    if (best.decided || last || work == 0) return best;
  }
}

}  // namespace flatray
