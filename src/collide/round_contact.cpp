#include "collide/round_contact.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "geom/clip_range.h"
#include "geom/decide.h"
#include "geom/pair.h"

namespace flatray {
namespace {

const auto kBounded = [](double x) { return Bounded(x); };
const auto kRational = [](double x) { return Rational(x); };

// The difference of the cores, round which the sum of the radii is laid. Everything is seen from
// the origin that moves: `from` is where a corner lies.
class RoundPair {
 public:
  RoundPair(const RoundBody& a, const RoundBody& b)
      : a_(a), b_(b), difference_(minkowski_difference(a.core.vertices, b.core.vertices)) {}

  const std::vector<DifferenceCorner>& corners() const { return difference_.corners; }
  bool has_area() const { return difference_.has_area; }
  bool has_sides() const { return corners().size() > 1; }
  std::size_t next(std::size_t k) const { return k + 1 == corners().size() ? 0 : k + 1; }

  template <class Make>
  auto radius(const Make& number) const {
    return number(a_.radius) + number(b_.radius);
  }
  // Vertex of b from vertex of a.
  template <class Make>
  auto from(const Make& number, std::size_t k) const {
    const DifferenceCorner& c = corners()[k];
    return pair_of(number, b_.core.vertices[c.b]) - pair_of(number, a_.core.vertices[c.a]);
  }
  template <class Make>
  auto way(const Make& number) const {
    return pair_of(number, b_.core.velocity) - pair_of(number, a_.core.velocity);
  }
  // The side that begins at a corner, counter-clockwise.
  template <class Make>
  auto side(const Make& number, std::size_t k) const {
    const DifferenceCorner& c = corners()[k];
    return c.edge_of_a
               ? pair_of(number, a_.core.vertices[c.along]) - pair_of(number, a_.core.vertices[c.a])
               : pair_of(number, b_.core.vertices[c.b]) -
                     pair_of(number, b_.core.vertices[c.along]);
  }

 private:
  const RoundBody &a_, &b_;
  const Difference difference_;
};

// When the origin crosses the disc about a corner, or the line of a side moved outward.
class RoundTime {
 public:
  RoundTime(const RoundPair& pair, std::size_t corner, bool on_side, int root)
      : pair_(&pair), corner_(corner), on_side_(on_side), root_(root) {}

  std::size_t corner() const { return corner_; }
  bool on_side() const { return on_side_; }

  // t = (p + s sqrt(q)) / a, a > 0.
  template <class Number>
  struct Form {
    Number p, q, a;
    int s;
  };
  template <class Make, class Number = std::invoke_result_t<Make, double>>
  Form<Number> form(const Make& number) const {
    const auto from = pair_->from(number, corner_), way = pair_->way(number);
    const Number radius = pair_->radius(number);
    if (!on_side_) {
      const Number a = dot(way, way), across = cross(from, way);
      return {-dot(from, way), radius * radius * a - across * across, a, root_};
    }
    // The outward normal is the side turned right: normal . v = -side x v. Coming in, it is
    // against the way, and both are taken with the other sign.
    const auto side = pair_->side(number, corner_);
    const Number p = cross(side, from), a = -cross(side, way),
                 q = radius * radius * dot(side, side);
    if (root_ < 0) return {-p, q, -a, -1};
    return {p, q, a, 1};
  }
  Bounded approximate() const {
    const auto f = form(kBounded);
    const Bounded root = square_root(f.q);
    return (f.s > 0 ? f.p + root : f.p - root) / f.a;
  }
  std::strong_ordering compare(double other) const {
    if (other == kInfinity) return std::strong_ordering::less;
    if (other == -kInfinity) return std::strong_ordering::greater;
    if (const auto sign = (approximate() - Bounded(other)).sign()) return order(*sign);
    const auto f = form(kRational);
    return order(Rational::root_sign(f.p - Rational(other) * f.a, f.s, f.q));
  }
  RoundedTime nearest() const {
    constexpr double kLargest = std::numeric_limits<double>::max();
    const auto rounded = approximate().nearest();
    if (rounded && std::fabs(*rounded) < kLargest) return {*rounded, false};
    if (compare(kLargest) > 0) return {kLargest, true};
    if (compare(-kLargest) < 0) return {-kLargest, true};
    const auto f = form(kRational);
    return {Rational::root_sum(f.p / f.a, f.s, f.q / (f.a * f.a)), false};
  }
  // Sign of u + v t for this t.
  template <class Linear>
  Sign sign(const Linear& linear) const {
    const auto [u, v] = linear(kBounded);
    if (const auto sign = (u + v * approximate()).sign()) return *sign;
    const auto f = form(kRational);
    const auto [eu, ev] = linear(kRational);
    const Sign s = ev.sign();
    return Rational::root_sign(eu * f.a + ev * f.p, f.s * static_cast<int>(s), ev * ev * f.q);
  }

 private:
  const RoundPair* pair_;
  std::size_t corner_;
  bool on_side_;
  int root_;
};

std::strong_ordering compare(const RoundTime& x, const RoundTime& y) {
  if (const auto sign = (x.approximate() - y.approximate()).sign()) return order(*sign);
  const auto f = x.form(kRational), g = y.form(kRational);
  return order(
      Rational::two_root_sign(f.p * g.a - g.p * f.a, f.s, f.q * g.a * g.a, -g.s, g.q * f.a * f.a));
}

// Whether the origin is at an inner place of a side when it crosses the side's line.
bool crosses_side(const RoundPair& pair, const RoundTime& time) {
  const std::size_t k = time.corner();
  const auto along = [&](std::size_t corner) {
    return [&pair, k, corner](const auto& number) {
      const auto side = pair.side(number, k);
      return std::pair(dot(side, pair.from(number, corner)), dot(side, pair.way(number)));
    };
  };
  return time.sign(along(k)) == Sign::positive && time.sign(along(pair.next(k))) == Sign::negative;
}

using RoundLine = LineHitOf<RoundTime>;

void add(const RoundTime& time, bool comes_in, RoundLine& line) {
  std::optional<RoundTime>& end = comes_in ? line.enter : line.exit;
  if (end && (compare(time, *end) < 0) != comes_in) return;
  if (end && compare(time, *end) == 0) return;
  end = time;
}

// What the whole line of motion has in common with the rounded difference. Needs   relative motion.
RoundLine hit_line(const RoundPair& pair) {
  RoundLine line;
  bool inner = false;
  for (std::size_t k = 0; k < pair.corners().size(); ++k) {
    const RoundTime first(pair, k, false, -1), last(pair, k, false, 1);
    const Sign chord = decide([&](const auto& number) { return first.form(number).q; });
    if (chord != Sign::negative) {
      add(first, true, line);
      add(last, false, line);
      inner |= chord == Sign::positive;
    }
    if (!pair.has_sides()) continue;
    const Sign turn =
        decide([&](const auto& number) { return cross(pair.side(number, k), pair.way(number)); });
    if (turn == Sign::zero) continue;
    const bool comes_in = turn == Sign::positive;
    const RoundTime time(pair, k, true, comes_in ? -1 : 1);
    if (!crosses_side(pair, time)) continue;
    add(time, comes_in, line);
    inner = true;
  }
  if (!line.enter) return line;
  line.kind = inner                                   ? HitClass::through
              : compare(*line.enter, *line.exit) == 0 ? HitClass::touch
                                                      : HitClass::along;
  return line;
}

// Where the origin lies if it does not move.
StartPlace place(const RoundPair& pair) {
  bool within = pair.has_area(), on_border = false;
  for (std::size_t k = 0; k < pair.corners().size(); ++k) {
    const auto side_of = [&](const auto& number) {
      return cross(pair.side(number, k), pair.from(number, k));
    };
    within = within && decide(side_of) != Sign::negative;
  }
  const auto look = [&](Sign beyond) {
    within |= beyond == Sign::negative;
    on_border |= beyond == Sign::zero;
  };
  for (std::size_t k = 0; k < pair.corners().size(); ++k) {
    look(decide([&](const auto& number) {
      const auto from = pair.from(number, k);
      const auto radius = pair.radius(number);
      return dot(from, from) - radius * radius;
    }));
    const auto ahead = [&](std::size_t corner) {
      return decide(
          [&](const auto& number) { return dot(pair.side(number, k), pair.from(number, corner)); });
    };
    if (!pair.has_sides() || ahead(k) != Sign::positive || ahead(pair.next(k)) != Sign::negative)
      continue;
    look(decide([&](const auto& number) {
      const auto side = pair.side(number, k);
      const auto across = cross(side, pair.from(number, k)), radius = pair.radius(number);
      return across * across - radius * radius * dot(side, side);
    }));
  }
  return within ? StartPlace::inside : on_border ? StartPlace::boundary : StartPlace::outside;
}

// The outward normal of the side of A - B that begins at a corner.
Vec2 side_normal(const DifferenceCorner& c, const RoundBody& a, const RoundBody& b) {
  const Vec2 along = c.edge_of_a ? Vec2(a.core.vertices[c.along] - a.core.vertices[c.a])
                                 : Vec2(b.core.vertices[c.b] - b.core.vertices[c.along]);
  return Vec2(along.y(), -along.x()).stableNormalized();
}

// The normal between two discs about vertices where they first touch: by how far they would pass each
// other, not by places at a rounded time, which far from the origin tell nothing.
Vec2 normal_of_discs(const DifferenceCorner& c, const RoundBody& a, const RoundBody& b) {
  const auto share = [&](bool squared_miss) {
    return round_once([&](const auto& number) {
      const auto from =
          pair_of(number, b.core.vertices[c.b]) - pair_of(number, a.core.vertices[c.a]);
      const auto way = pair_of(number, b.core.velocity) - pair_of(number, a.core.velocity);
      const auto radius = number(a.radius) + number(b.radius);
      const auto whole = radius * radius * dot(way, way), across = cross(from, way);
      return (squared_miss ? across * across : whole - across * across) / whole;
    });
  };
  const Sign beside = decide([&](const auto& number) {
    return cross(pair_of(number, b.core.vertices[c.b]) - pair_of(number, a.core.vertices[c.a]),
                 pair_of(number, b.core.velocity) - pair_of(number, a.core.velocity));
  });
  const Vec2 way = (b.core.velocity - a.core.velocity).stableNormalized();
  const double sine = std::sqrt(share(true)) * static_cast<int>(beside);
  return -std::sqrt(share(false)) * way - sine * Vec2(-way.y(), way.x());
}

RoundPlace place_on(const RoundFeature& feature, const RoundBody& a, const RoundBody& b, double t,
                    const Vec2& normal) {
  const DifferenceCorner& c = feature.corner;
  if (feature.on_edge && c.edge_of_a)
    return {b.core.vertices[c.b] + t * b.core.velocity - b.radius * normal, normal};
  return {a.core.vertices[c.a] + t * a.core.velocity + a.radius * normal, normal};
}

// Orders ways out alike whichever body comes first: the shortest; of equal ones that on which they come
// nearer the fastest; then by the angle of the line they lie on.
std::tuple<double, double, double> rank_of(double length, const Vec2& normal,
                                           const Vec2& velocity) {
  const bool is_down = normal.y() < 0 || (normal.y() == 0 && normal.x() < 0);
  return {length, normal.dot(velocity), is_down ? normal.x() : -normal.x()};
}

}  // namespace

RoundContact round_contact(const Contact& met, const RoundBody& a, const RoundBody& b) {
  const auto feature = [&](const ContactFeature& f) -> std::optional<RoundFeature> {
    if (f.edge == kNoEdge) return std::nullopt;
    const auto edge = static_cast<std::uint32_t>(f.edge),
               vertex = static_cast<std::uint32_t>(f.vertex);
    const auto& ring = f.edge_of_a ? a.core.vertices : b.core.vertices;
    const std::uint32_t end = edge + 1 == ring.size() ? 0 : edge + 1;
    return RoundFeature{
        {f.edge_of_a ? edge : vertex, f.edge_of_a ? vertex : edge, f.edge_of_a, end, edge}, true};
  };
  return {met.times, feature(met.first), feature(met.last)};
}

RoundContact round_contact(const RoundBody& a, const RoundBody& b, Range within) {
  if (a.radius == 0 && b.radius == 0) return round_contact(contact(a.core, b.core, within), a, b);
  const RoundPair pair(a, b);
  if (a.core.velocity == b.core.velocity) return {point_test(place(pair), within), {}, {}};
  const RoundLine line = hit_line(pair);
  RoundContact found{clip_to_range(line, within), {}, {}};
  const auto feature = [&](const RoundTime& time) {
    return RoundFeature{pair.corners()[time.corner()], time.on_side()};
  };
  if (!found.times) return found;
  if (line.enter->compare(within.low) > 0) found.first = feature(*line.enter);
  if (line.exit->compare(within.high) < 0) found.last = feature(*line.exit);
  return found;
}

RoundPlace place_at(const RoundFeature& feature, const RoundBody& a, const RoundBody& b, double t) {
  if (!feature.on_edge) return place_on(feature, a, b, t, normal_of_discs(feature.corner, a, b));
  const Vec2 normal = side_normal(feature.corner, a, b);
  // Out of the first: against the way in which it is met.
  const double way = normal.dot((a.core.velocity - b.core.velocity).stableNormalized());
  return place_on(feature, a, b, t, way < 0 ? Vec2(-normal) : normal);
}

RoundPlace resting_place(const RoundBody& a, const RoundBody& b, double t) {
  const Difference difference = minkowski_difference(a.core.vertices, b.core.vertices);
  const Vec2 velocity = b.core.velocity - a.core.velocity, moved = t * velocity;
  const auto from = [&](const DifferenceCorner& c) -> Vec2 {
    return (b.core.vertices[c.b] - a.core.vertices[c.a]) + moved;
  };
  std::optional<RoundPlace> nearest;
  std::tuple least(kInfinity, 0.0, 0.0);
  const std::size_t count = difference.corners.size();
  for (std::size_t k = 0; k < count; ++k) {
    const DifferenceCorner& corner = difference.corners[k];
    const Vec2 start = from(corner), end = from(difference.corners[k + 1 == count ? 0 : k + 1]);
    const Vec2 outward = count == 1 ? Vec2(0, 0) : side_normal(corner, a, b);
    const Vec2 along(-outward.y(), outward.x());
    const bool beside = count > 1 && along.dot(start) >= 0 && along.dot(end) <= 0;
    if (beside && !difference.has_area && outward.dot(start) < 0) continue;  // the side back is
    const double distance = beside ? std::fabs(outward.dot(start)) : start.stableNorm();
    const bool is_corner = !beside && distance > 0;
    const Vec2 normal = is_corner ? Vec2(start.stableNormalized()) : outward;
    const auto rank = rank_of(distance, normal, velocity);
    if (!(rank < least)) continue;
    least = rank;
    nearest = place_on({corner, !is_corner}, a, b, t, normal);
  }
  return nearest.value_or(RoundPlace{a.core.vertices.front(), {0, 0}});
}

}  // namespace flatray
