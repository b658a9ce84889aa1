#include "oracle/nearest.h"

#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "geom/exact.h"
#include "oracle/bezier.h"
#include "oracle/curves.h"
#include "oracle/whole.h"

namespace flatray::oracle {
namespace {

int sign_of(const Int128& x) { return x < 0 ? -1 : x > 0 ? 1 : 0; }
int sign_of(const Rational& x) { return static_cast<int>(x.sign()); }

// The two arithmetics: how a fraction is made, and what it is as a double.
struct WholeNumbers {
  using Number = Int128;
  using Time = Fraction;
  static constexpr auto kName = NearestWall::By::whole_numbers;
  static Time time(const Number& numerator, const Number& denominator) {
    return denominator < 0 ? Fraction{-numerator, -denominator} : Fraction{numerator, denominator};
  }
};
struct Rationals {
  using Number = Rational;
  using Time = Rational;
  static constexpr auto kName = NearestWall::By::rationals;
  static Time time(const Number& numerator, const Number& denominator) {
    return numerator / denominator;
  }
};

template <class Number>
struct Point {
  Number x, y;
};

template <class Kind>
class Search {
 public:
  using Number = typename Kind::Number;
  using Time = typename Kind::Time;

  Search(const Point<Number>& origin, const Point<Number>& direction)
      : origin_(origin), direction_(direction) {}

  void offer(std::int64_t number, const Point<Number>& a, const Point<Number>& b) {
    const Number ax = a.x - origin_.x, ay = a.y - origin_.y;
    const Number ex = b.x - a.x, ey = b.y - a.y;
    if (sign_of(direction_.x) == 0 && sign_of(direction_.y) == 0) return offer_point(number, a, b);
    const Number denominator = direction_.x * ey - direction_.y * ex;
    const Number place = ax * direction_.y - ay * direction_.x;
    const int turn = sign_of(denominator);
    if (turn == 0) {
      if (sign_of(place) == 0) offer_along(number, a, b);
      return;
    }
    const Number time = ax * ey - ay * ex;
    // t = time / denominator, and place / denominator runs from 0 at a to 1 at b.
    const int from_a = sign_of(place) * turn;
    const int from_b = sign_of(Number(place - denominator)) * turn;
    if (sign_of(time) * turn < 0 || from_a < 0 || from_b > 0) return;
    offer(number, HitClass::touch, from_a == 0 || from_b == 0, Kind::time(time, denominator));
  }

  std::int64_t wall = -1;
  HitClass kind = HitClass::miss;
  bool at_end = false;
  std::optional<Time> best;

 private:
  void offer(std::int64_t number, HitClass met, bool end, Time time) {
    if (best && !(time < *best)) return;
    wall = number;
    kind = met;
    at_end = end;
    best = std::move(time);
  }

  // How far along the ray's line a point on it lies.
  Time time_of(const Point<Number>& p) const {
    return sign_of(direction_.x) != 0 ? Kind::time(p.x - origin_.x, direction_.x)
                                      : Kind::time(p.y - origin_.y, direction_.y);
  }

  // The wall lies on the ray's line.
  void offer_along(std::int64_t number, const Point<Number>& a, const Point<Number>& b) {
    const Time zero{}, ta = time_of(a), tb = time_of(b);
    const Time& first = tb < ta ? tb : ta;
    const Time& last = tb < ta ? ta : tb;
    if (last < zero) return;
    const bool one_point = first == last;
    const bool inside = first < zero;
    const bool leaves_only = !one_point && last == zero;
    const HitClass met = one_point || leaves_only ? HitClass::touch : HitClass::along;
    offer(number, met, !inside || last == zero, inside ? zero : first);
  }

  // On the wall's line: between its ends if on neither axis beyond both.
  void offer_point(std::int64_t number, const Point<Number>& a, const Point<Number>& b) {
    const Number ax = a.x - origin_.x, ay = a.y - origin_.y;
    const Number bx = b.x - origin_.x, by = b.y - origin_.y;
    if (sign_of(Number(ax * by - ay * bx)) != 0) return;
    if (sign_of(ax) * sign_of(bx) > 0 || sign_of(ay) * sign_of(by) > 0) return;
    const bool end =
        (sign_of(ax) == 0 && sign_of(ay) == 0) || (sign_of(bx) == 0 && sign_of(by) == 0);
    offer(number, HitClass::touch, end, Time{});
  }

  Point<Number> origin_, direction_;
};

Point<Rational> exact(const Vec2& v) { return {v.x(), v.y()}; }

// The first wall of the candidates.
template <class Kind, class Make>
NearestWall search(const Make& point, std::span<const Candidate> candidates) {
  Search<Kind> found(point(0), point(1));
  for (std::size_t i = 0; i < candidates.size(); ++i)
    found.offer(candidates[i].wall, point(2 + 2 * i), point(3 + 2 * i));
  NearestWall nearest;
  nearest.by = Kind::kName;
  if (found.wall < 0) return nearest;
  nearest.wall = found.wall;
  nearest.kind = found.kind;
  nearest.at_end = found.at_end;
  nearest.t = found.best->nearest();
  return nearest;
}

NearestWall exact_search(const Ray& ray, std::span<const Segment> walls,
                         std::span<const Candidate> candidates) {
  std::vector<double> xs{ray.origin.x(), ray.direction.x()};
  std::vector<double> ys{ray.origin.y(), ray.direction.y()};
  for (const Candidate& candidate : candidates) {
    const Segment& wall = walls[static_cast<std::size_t>(candidate.wall)];
    xs.insert(xs.end(), {wall.a.x(), wall.b.x()});
    ys.insert(ys.end(), {wall.a.y(), wall.b.y()});
  }
  // A unit for each axis: no formula adds a length along x to one along y.
  const auto whole_x = whole_numbers(xs), whole_y = whole_numbers(ys);
  if (whole_x && whole_y) {
    const auto point = [&](std::size_t i) {
      return Point<Int128>{whole_x->numbers[i], whole_y->numbers[i]};
    };
    return search<WholeNumbers>(point, candidates);
  }
  const auto point = [&](std::size_t i) { return Point<Rational>{xs[i], ys[i]}; };
  return search<Rationals>(point, candidates);
}

}  // namespace

NearestWall nearest_wall(const Ray& ray, std::span<const Segment> walls) {
  std::vector<Candidate> all(walls.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i].wall = static_cast<std::int64_t>(i);
  return exact_search(ray, walls, all);
}

namespace {

// Of a Bezier curve it takes more than a square root.
using Time = std::variant<Surd, Algebraic>;
std::strong_ordering compare(const Time& a, const Time& b) {
  if (a.index() == 0 && b.index() == 0) return std::get<Surd>(a) <=> std::get<Surd>(b);
  const auto algebraic = [](const auto& t) { return Algebraic(t); };
  return std::visit(algebraic, a) <=> std::visit(algebraic, b);
}

struct FirstOfWall {
  Time t;
  HitClass kind;
  bool at_end;
  Root root;
};
template <class Met>
std::optional<FirstOfWall> first_of(Met met) {
  if (!met) return std::nullopt;
  return FirstOfWall{std::move(met->t), met->kind, met->at_end, met->root};
}
std::vector<Vec2> points_of(const Bezier& wall) {
  return {wall.points.begin(), wall.points.begin() + wall.degree + 1};
}
std::optional<FirstOfWall> meeting_of(const Ray& ray, const Arc& wall) {
  return first_of(first_meeting(ray, wall));
}
std::optional<FirstOfWall> meeting_of(const Ray& ray, const Bezier& wall) {
  return first_of(first_meeting(ray, points_of(wall)));
}
// Curves are asked alone.
std::optional<FirstOfWall> meeting_of(const Ray&, const Segment&) { return std::nullopt; }

}  // namespace

static std::optional<double> time_of(const Ray& ray, const Segment& wall, Root) {
  const NearestWall met = nearest_wall(ray, {&wall, 1});
  return met ? std::optional(met.t) : std::nullopt;
}
static std::optional<double> time_of(const Ray& ray, const Arc& wall, Root root) {
  const auto met = root_of(ray, wall.curve, root);
  return met ? std::optional(met->nearest()) : std::nullopt;
}

static std::optional<double> time_of(const Ray& ray, const Bezier& wall, Root root) {
  for (const BezierMeeting& met : meetings_with_bezier(ray, points_of(wall)))
    if (met.root == root) return met.t.nearest();
  return std::nullopt;
}

std::optional<double> time_of(const Ray& ray, const Surfaces& walls, std::uint32_t wall,
                              Root root) {
  return walls.visit(wall, [&](const auto& met) { return time_of(ray, met, root); });
}

NearestWalls::NearestWalls(const Surfaces& walls) : walls_(walls) {
  for (const std::uint32_t number : walls.curve_numbers)
    reaches_.push_back(walls.visit(number, [](const auto& wall) { return reach_of(wall); }));
}

NearestWall NearestWalls::of(const Ray& ray) {
  find_candidates(ray, walls_.segments, straight_);
  long double first = std::numeric_limits<long double>::infinity();
  for (const Candidate& each : straight_) first = std::min(first, each.sure ? each.high : first);
  find_candidates(ray, reaches_, first, round_);
  if (!round_.empty()) return among_curves(ray);
  if (straight_.empty()) return {};
  const Candidate& only = straight_.front();
  const double t = static_cast<double>(only.low);
  const bool settled = straight_.size() == 1 && only.sure && t == static_cast<double>(only.high);
  NearestWall nearest = settled ? NearestWall{only.wall, HitClass::touch, false, t}
                                : exact_search(ray, walls_.segments, straight_);
  if (nearest) nearest.wall = walls_.segment_numbers[static_cast<std::size_t>(nearest.wall)];
  return nearest;
}

NearestWall NearestWalls::among_curves(const Ray& ray) const {
  Search<Rationals> straight(exact(ray.origin), exact(ray.direction));
  for (const Candidate& each : straight_) {
    const Segment& wall = walls_.segments[static_cast<std::size_t>(each.wall)];
    straight.offer(each.wall, exact(wall.a), exact(wall.b));
  }
  NearestWall nearest;
  std::optional<Time> best;
  if (straight.best) {
    best = Surd{*straight.best, 0, 0};
    nearest = {walls_.segment_numbers[static_cast<std::size_t>(straight.wall)], straight.kind,
               straight.at_end};
  }
  for (const Candidate& each : round_) {
    const std::uint32_t number = walls_.curve_numbers[static_cast<std::size_t>(each.wall)];
    walls_.visit(number, [&](const auto& wall) {
      auto met = meeting_of(ray, wall);
      if (!met) return;
      const auto order = best ? compare(met->t, *best) : std::strong_ordering::less;
      if (order > 0 || (order == 0 && number > nearest.wall)) return;
      best = std::move(met->t);
      nearest = {number, met->kind, met->at_end};
      nearest.root = met->root;
    });
  }
  nearest.by = NearestWall::By::rationals;
  if (best) nearest.t = std::visit([](const auto& t) { return t.nearest(); }, *best);
  return nearest;
}

}  // namespace flatray::oracle
