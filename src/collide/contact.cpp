#include "collide/contact.h"

#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

#include "collide/minkowski.h"
#include "geom/clip_range.h"
#include "geom/decide.h"
#include "geom/pair.h"
#include "geom/sides.h"

namespace flatray {
namespace {

// What double-doubles tell of `ask(number)`, if they leave no doubt.
template <class Ask>
auto tell(const Ask& ask) {
  decltype(ask(kQuick)) told;
  with_fused([&] { told = ask(kQuick); });
  return told ? told : ask(kBounded);
}

// The outline of the difference of two cores, round which the sum of the radii is laid. All is seen
// from the origin that moves: `from` is where a corner lies.
class MovingDifference {
 public:
  MovingDifference(const MovingBody& a, const MovingBody& b)
      : a_(a), b_(b), difference_(minkowski_difference(a.vertices, b.vertices)) {}

  const DifferenceCorner& corner(std::size_t k) const { return difference_.corners[k]; }
  std::size_t size() const { return difference_.corners.size(); }
  std::size_t next(std::size_t k) const { return k + 1 == size() ? 0 : k + 1; }
  bool has_area() const { return difference_.has_area; }
  bool is_round() const { return a_.radius > 0 || b_.radius > 0; }

  template <class Make>
  auto radius(const Make& number) const {
    return number(a_.radius) + number(b_.radius);
  }
  // Vertex of b from vertex of a.
  template <class Make>
  auto from(const Make& number, std::size_t k) const {
    return pair_of(number, vertex_b(k)) - pair_of(number, vertex_a(k));
  }
  template <class Make>
  auto way(const Make& number) const {
    return pair_of(number, b_.velocity) - pair_of(number, a_.velocity);
  }
  // The edge that begins at a corner, counter-clockwise.
  template <class Make>
  auto edge(const Make& number, std::size_t k) const {
    const Segment line = edge(k);
    return pair_of(number, line.b) - pair_of(number, line.a);
  }
  // When the origin crosses its line.
  HitTime crossing(std::size_t k) const {
    const Segment line = edge(k);
    return HitTime::on_line({vertex_b(k), b_.velocity}, vertex_a(k), line.a, line.b, a_.velocity);
  }
  // Side of a corner seen along the way: positive to the left.
  Sign side(std::size_t k) const {
    return cross_sign(a_.velocity, b_.velocity, vertex_b(k), vertex_a(k));
  }

 private:
  const Vec2& vertex_a(std::size_t k) const { return a_.vertices[corner(k).a]; }
  const Vec2& vertex_b(std::size_t k) const { return b_.vertices[corner(k).b]; }
  // One of a, or of b turned round.
  Segment edge(std::size_t k) const {
    const auto& [a, b, edge_of_a, far, number] = corner(k);
    return edge_of_a ? Segment{a_.vertices[a], a_.vertices[far]}
                     : Segment{b_.vertices[far], b_.vertices[b]};
  }

  const MovingBody &a_, &b_;
  const Difference difference_;
};

// When the origin crosses the line of an edge moved outward by the radius, or the circle about a
// corner: t = (p + s sqrt(q)) / a, a > 0.
class CrossingTime {
 public:
  CrossingTime(const MovingDifference& pair, std::size_t corner, bool on_edge, bool comes_in)
      : pair_(&pair), corner_(corner), on_edge_(on_edge), comes_in_(comes_in) {}

  std::size_t corner() const { return corner_; }
  bool on_edge() const { return on_edge_; }

  template <class Number>
  struct Form {
    Number p, q, a;
  };
  template <class Make, class Number = std::invoke_result_t<Make, double>>
  Form<Number> form(const Make& number) const {
    const auto from = pair_->from(number, corner_), way = pair_->way(number);
    const Number radius = pair_->radius(number);
    if (!on_edge_) {
      const Number a = dot(way, way), across = cross(from, way);
      return {-dot(from, way), radius * radius * a - across * across, a};
    }
    // The outward normal is the edge turned right: normal . v = -edge x v. Coming in, it is
    // against the way, and both are taken with the other sign.
    const auto edge = pair_->edge(number, corner_);
    const Number p = cross(edge, from), a = cross(edge, way), q = radius * radius * dot(edge, edge);
    if (comes_in_) return {-p, q, a};
    return {p, q, -a};
  }
  std::strong_ordering compare(double other) const {
    if (std::isinf(other)) return 0 <=> (other > 0 ? 1 : -1);
    return order(sign([&](const auto& number) { return std::pair(number(-other), number(1.0)); }));
  }
  RoundedTime nearest() const {
    constexpr double kLargest = std::numeric_limits<double>::max();
    const auto rounded = tell([&](const auto& number) { return at(number).nearest(); });
    if (rounded && std::fabs(*rounded) < kLargest) return {*rounded, false};
    if (compare(kLargest) > 0) return {kLargest, true};
    if (compare(-kLargest) < 0) return {-kLargest, true};
    const auto f = form(kRational);
    return {Rational::root_sum(f.p / f.a, root(), f.q / (f.a * f.a)), false};
  }
  // Sign of u + v t for this t.
  template <class Linear>
  Sign sign(const Linear& linear) const {
    const auto sign = tell([&](const auto& number) {
      const auto [u, v] = linear(number);
      return (u + v * at(number)).sign();
    });
    if (sign) return *sign;
    const auto f = form(kRational);
    const auto [u, v] = linear(kRational);
    return Rational::root_sign(u * f.a + v * f.p, root() * static_cast<int>(v.sign()), v * v * f.q);
  }
  friend std::strong_ordering compare(const CrossingTime& x, const CrossingTime& y) {
    const auto sign =
        tell([&](const auto& number) { return (x.at(number) - y.at(number)).sign(); });
    if (sign) return order(*sign);
    const auto f = x.form(kRational), g = y.form(kRational);
    return order(Rational::two_root_sign(f.p * g.a - g.p * f.a, x.root(), f.q * g.a * g.a,
                                         -y.root(), g.q * f.a * f.a));
  }

 private:
  int root() const { return comes_in_ ? -1 : 1; }
  template <class Make, class Number = std::invoke_result_t<Make, double>>
  Number at(const Make& number) const {
    const auto f = form(number);
    const Number reach = square_root(f.q);
    return (comes_in_ ? f.p - reach : f.p + reach) / f.a;
  }

  const MovingDifference* pair_;
  std::size_t corner_;
  bool on_edge_, comes_in_;
};

// The edges of a line are numbers of corners: of the edge that begins there, or the corner itself after
// all of those.
using RoundLine = LineHitOf<CrossingTime>;

// Whether the origin is at an inner place of an edge when it crosses the edge's line.
bool crosses_edge(const MovingDifference& pair, const CrossingTime& time) {
  const std::size_t k = time.corner();
  const auto along = [&](std::size_t corner) {
    return [&pair, k, corner](const auto& number) {
      const auto edge = pair.edge(number, k);
      return std::pair(dot(edge, pair.from(number, corner)), dot(edge, pair.way(number)));
    };
  };
  return time.sign(along(k)) == Sign::positive && time.sign(along(pair.next(k))) == Sign::negative;
}

int number_of(const MovingDifference& pair, const CrossingTime& time) {
  return static_cast<int>(time.corner() + (time.on_edge() ? 0 : pair.size()));
}

// The line is in the shape from the first of all times at which it comes in to the last at which it goes
// out.
void add(const CrossingTime& time, bool comes_in, RoundLine& line) {
  std::optional<CrossingTime>& end = comes_in ? line.enter : line.exit;
  if (!end || (comes_in ? compare(time, *end) < 0 : compare(time, *end) > 0)) end = time;
}

// What the whole line of motion has in common with the rounded difference.
RoundLine hit_rounded(const MovingDifference& pair) {
  RoundLine line;
  bool inner = false;
  for (std::size_t k = 0; k < pair.size(); ++k) {
    const CrossingTime first(pair, k, false, true), last(pair, k, false, false);
    const Sign chord = decide([&](const auto& number) { return first.form(number).q; });
    if (chord != Sign::negative) {
      add(first, true, line);
      add(last, false, line);
      inner |= chord == Sign::positive;
    }
    if (pair.size() == 1) continue;
    const Sign turn =
        decide([&](const auto& number) { return cross(pair.edge(number, k), pair.way(number)); });
    if (turn == Sign::zero) continue;
    const bool comes_in = turn == Sign::positive;
    const CrossingTime time(pair, k, true, comes_in);
    if (!crosses_edge(pair, time)) continue;
    add(time, comes_in, line);
    inner = true;
  }
  if (!line.enter) return line;
  line.edge_enter = number_of(pair, *line.enter);
  line.edge_exit = number_of(pair, *line.exit);
  line.kind = inner                                   ? HitClass::through
              : compare(*line.enter, *line.exit) == 0 ? HitClass::touch
                                                      : HitClass::along;
  return line;
}

// The same of cores alone; nullopt where all corners are on the line. The sides of the corners tell the
// edges by which the origin comes in and goes out, so that no two times are compared (geom/sides.h).
std::optional<LineHit> hit_cores(const MovingDifference& pair) {
  const Sides sides = sides_of(
      pair.size(), [&](std::size_t k) { return pair.side(k); }, [](std::size_t) { return true; });
  if (!sides.left && !sides.right) return std::nullopt;
  if (sides.down == kNoEdge) return LineHit{};
  const auto time = [&](int edge) { return pair.crossing(static_cast<std::size_t>(edge)); };
  return LineHit{time(sides.down), time(sides.up), sides.down, sides.up,
                 sides.kind(pair.has_area())};
}

ContactFeature feature_of(const MovingDifference& pair, int number) {
  if (number == kNoEdge) return {};
  const auto at = static_cast<std::size_t>(number);
  const bool on_edge = at < pair.size();
  const DifferenceCorner& c = pair.corner(on_edge ? at : at - pair.size());
  const int a = static_cast<int>(c.a), b = static_cast<int>(c.b), edge = static_cast<int>(c.edge);
  if (on_edge) return {c.edge_of_a, edge, c.edge_of_a ? b : a};
  return pair.is_round() ? ContactFeature{true, kNoEdge, b, a} : ContactFeature{};
}

template <class Time>
Contact contact_of(const MovingDifference& pair, const LineHitOf<Time>& line, Range within) {
  Contact found{clip_to_range(line, within), {}, {}};
  found.first = feature_of(pair, std::exchange(found.times.edge_enter, kNoEdge));
  found.last = feature_of(pair, std::exchange(found.times.edge_exit, kNoEdge));
  return found;
}

}  // namespace

const char* contact_name(StartPlace start) {
  constexpr const char* kNames[] = {"apart", "touching", "overlapping"};
  return kNames[static_cast<std::size_t>(start)];
}

Contact contact(const MovingBody& a, const MovingBody& b, Range within) {
  // How they lie at t = 0 does not hang on their motion: so of what has none any other tells it.
  if (a.velocity == b.velocity) {
    const MovingBody still{a.vertices, {0, 0}, a.radius}, moving{b.vertices, {1, 0}, b.radius};
    return {point_test(contact(still, moving, {0, 0}).times.start, within), {}, {}};
  }
  const MovingDifference pair(a, b);
  if (!pair.is_round())
    if (const auto line = hit_cores(pair)) return contact_of(pair, *line, within);
  return contact_of(pair, hit_rounded(pair), within);
}

}  // namespace flatray
