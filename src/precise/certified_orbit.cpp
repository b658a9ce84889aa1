// Part of the module flatray_certified.so.
#include "precise/certified_orbit.h"

#include <algorithm>

#include "base/check.h"
#include "precise/ball.h"
#include "precise/certain.h"
#include "precise/flight.h"
#include "precise/module.h"

namespace flatray {
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
struct MakeCertain {
  Certain operator()(double x) const { return Certain(x); }
};

std::optional<double> rounded(const Ball& x, double scale) { return x.nearest_or_even(scale); }
std::optional<double> rounded(const Certain& x, double) { return x.value().nearest(); }

template <class Number>
std::optional<Vec2> rounded(const Pair<Number>& point, double scale) {
  const auto x = rounded(point.x, scale), y = rounded(point.y, scale);
  return x && y ? std::optional(Vec2(*x, *y)) : std::nullopt;
}

// A direction at length 1, of which the square of the length is given.
std::optional<Vec2> rounded_out(const Pair<Ball>& direction, const Ball& size) {
  const Ball length = square_root(size);
  return rounded(Pair<Ball>{direction.x / length, direction.y / length}, 1);
}
std::optional<Vec2> rounded_out(const Pair<Certain>& direction, const Certain& size) {
  const auto share = [&](const Rational& x) {
    return Rational::root_sum(0, static_cast<int>(x.sign()), x * x / size.value());
  };
  return Vec2(share(direction.x.value()), share(direction.y.value()));
}

// Bits that the numbers of a flight hold, and what a wall costs then, counted in bits of balls: long
// fractions are reduced.
unsigned bits_of(const Flight<Ball, MakeBall>&, unsigned working) { return working; }
unsigned bits_of(const Flight<Certain, MakeCertain>& flight, unsigned) {
  std::size_t most = 0;
  for (const Certain* x : {&flight.moment(), &flight.direction().x, &flight.direction().y,
                           &flight.point().x, &flight.point().y})
    most = std::max(most, x->value().bits());
  return static_cast<unsigned>(most);
}
std::uint64_t cost_of(const Flight<Ball, MakeBall>&, unsigned bits) { return bits; }
std::uint64_t cost_of(const Flight<Certain, MakeCertain>&, unsigned bits) {
  return bits + std::uint64_t{bits} * bits / 4096;
}

double largest_coordinate(const Surfaces& walls) {
  const Bounds box = bounds_of(walls);
  const double largest = std::max(box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff());
  return std::min(largest, std::numeric_limits<double>::max());
}

// The orbit as far as an arithmetic tells it.
template <class Number, class Make>
class Follower {
 public:
  /// `bits` is the working precision of balls.
  Follower(const Surfaces& walls, const CertifiedRules& rules, const Ray& start, const Make& make,
           unsigned bits)
      : rules_(rules),
        periodic_(walls, rules.materials),
        flight_(walls, periodic_, start, make),
        flown_(make(0)),
        scale_(largest_coordinate(walls)),
        walls_(walls.size() + 1),
        bits_(bits),
        first_entry_(flight_.point()) {}

  // Takes what it does from `work`, and is undecided where none is left.
  CertifiedOrbit follow(std::uint64_t bounces, std::uint64_t& work) {
    while (orbit_.decided && orbit_.end == OrbitEnd::limit && orbit_.bounces.size() < bounces) {
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
    if (absorbs(next)) return stop(OrbitEnd::absorbed, next);
    if (next.kind == Prospect::Kind::corner) return stop(OrbitEnd::corner, next);
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
    const auto point = rounded(flight_.point(), scale_);
    const auto t = rounded(flown_, 1);
    const auto up = rounded_out(normal, dot(normal, normal));
    const auto in = rounded_out(way, flight_.size());
    const auto out = rounded_out(flight_.direction(), flight_.size());
    if (!point || !t || !up || !in || !out) return false;
    orbit_.bounces.push_back({wall, *point, *t, *up, *in, *out});
    crossings_ = 0;
    flown_ = flown_ - flown_;
    return true;
  }

  // Adds the t of a straight way.
  void fly(const Pair<Number>& from, const Pair<Number>& to, const Pair<Number>& way) {
    flown_ = flown_ + dot(to - from, way) / flight_.size();
  }

  bool absorbs(const Prospect& next) const {
    return !rules_.materials.empty() &&
           std::all_of(next.walls.begin(), next.walls.end(), [&](std::uint32_t wall) {
             return rules_.materials[wall] == Material::absorb;
           });
  }

  bool cross(const Prospect& next) {
    const Pair<Number> start = flight_.point();
    const auto left = flight_.cross_over(next);
    if (!left) return false;
    fly(start, *left, flight_.direction());
    const auto from = rounded(*left, scale_), to = rounded(flight_.point(), scale_);
    if (!from || !to) return false;
    orbit_.crossings.push_back({orbit_.bounces.size(), *from, *to});
    const Pair<Number>& entry = flight_.point();
    const bool circles = crossings_ > 0 && is_same(first_entry_, entry);
    if (crossings_++ == 0) first_entry_ = entry;
    if (circles || crossings_ >= kMostCrossings)
      return finish(OrbitEnd::escape, rounded_out(flight_.direction(), flight_.size()), orbit_.out);
    return true;
  }

  static bool is_same(const Pair<Number>& a, const Pair<Number>& b) {
    return (a.x - b.x).sign() == Sign::zero && (a.y - b.y).sign() == Sign::zero;
  }

  bool stop(OrbitEnd end, const Prospect& next) {
    const auto point = flight_.corner_at(next.walls.front());
    if (!point) return false;
    orbit_.end_surfaces = next.walls;
    return finish(end, rounded(*point, scale_), orbit_.end_point);
  }

  bool finish(OrbitEnd end, const std::optional<Vec2>& value, Vec2& out) {
    if (!value) return false;
    orbit_.end = end;
    out = *value;
    return true;
  }

  const CertifiedRules& rules_;
  PeriodicWalls periodic_;
  Flight<Number, Make> flight_;
  Number flown_;  // t since the last bounce
  double scale_;
  std::size_t walls_;
  unsigned bits_;
  std::uint32_t crossings_ = 0;  // since the last bounce
  Pair<Number> first_entry_;     // to which the first of them led
  CertifiedOrbit orbit_;
};

CertifiedOrbit in_balls(const Surfaces& walls, const CertifiedRules& rules, const Ray& start,
                        std::uint64_t bounces, unsigned bits, std::uint64_t& work) {
  const MakeBall make{static_cast<int>(bits)};
  return Follower<Ball, MakeBall>(walls, rules, start, make, bits).follow(bounces, work);
}

CertifiedOrbit in_rationals(const Surfaces& walls, const CertifiedRules& rules, const Ray& start,
                            std::uint64_t bounces, std::uint64_t& work) {
  CertifiedOrbit orbit =
      Follower<Certain, MakeCertain>(walls, rules, start, {}, 0).follow(bounces, work);
  orbit.rational = true;
  return orbit;
}

}  // namespace

CertifiedOrbit certify(const Surfaces& walls, const Ray& start, std::uint64_t bounces,
                       const CertifiedRules& rules) {
  FLATRAY_CHECK(rules.materials.empty() || rules.materials.size() == walls.size());
  std::vector<Material> materials(rules.materials.begin(), rules.materials.end());
  materials.resize(walls.size(), Material::mirror);
  Orbit at_start = trace_orbit(walls, materials, start, 0);
  if (at_start.end != OrbitEnd::limit) {
    CertifiedOrbit stays;
    stays.end = at_start.end;
    stays.out = at_start.out;
    stays.end_point = at_start.end_point;
    stays.end_surfaces = std::move(at_start.end_surfaces);
    return stays;
  }
  std::uint64_t work = rules.most_work.value_or(work_for(rules.most_bits));
  const bool straight = walls.segments.size() == walls.size();
  CertifiedOrbit best;
  const auto keep = [&](CertifiedOrbit orbit) {
    const bool further = orbit.bounces.size() > best.bounces.size();
    if (orbit.decided || orbit.bounces.size() >= best.bounces.size()) best = std::move(orbit);
    return further;
  };
  for (unsigned bits = kFirstBits;; bits = std::min(2 * bits, rules.most_bits)) {
    const bool further = keep(in_balls(walls, rules, start, bounces, bits, work));
    if (best.decided) return best;
    const bool last = bits >= rules.most_bits || work == 0;
    if (straight && (!further || last) && !best.rational)
      keep(in_rationals(walls, rules, start, bounces, work));
    if (best.decided || last) return best;
  }
}

}  // namespace flatray
