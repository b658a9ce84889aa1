#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "trace/surfaces.h"
#include "transport/landing.h"

namespace flatray {

/// Two numbers of any arithmetic.
template <class Number>
struct Pair {
  Number x, y;

  friend Pair operator-(const Pair& a, const Pair& b) { return {a.x - b.x, a.y - b.y}; }
};

template <class Number>
Number dot(const Pair<Number>& a, const Pair<Number>& b) {
  return a.x * b.x + a.y * b.y;
}

template <class Number>
Number cross(const Pair<Number>& a, const Pair<Number>& b) {
  return a.x * b.y - a.y * b.x;
}

/// What a ray comes to.
struct Prospect {
  enum class Kind : std::uint8_t {
    wall,    ///< meets one, between its ends
    corner,  ///< meets an end, or several walls at once
    escape,  ///< meets nothing
    open     ///< not to be told in this arithmetic
  } kind;
  std::vector<std::uint32_t> walls;  ///< ascending; one for a wall
};

/// A ray among mirrors, as exact as its arithmetic. It is a line x: x cross d = m, whose point met
/// does not enter what comes after a straight wall: errors grow there by sqrt 2 a bounce at most,
/// which is how a turn is bounded in components. Places on it count by x.d.
///
/// Needs   Number as geom/bounded.h has it; make(double) gives one without error. Walls that outlive
///         it, a direction that is not zero, a start in no corner.
/// Gives   what is told is true, whatever the arithmetic.
template <class Number, class Make>
class Flight {
 public:
  Flight(const Surfaces& walls, const Ray& start, Make make)
      : walls_(walls),
        make_(make),
        direction_(pair(start.direction)),
        moment_(cross(pair(start.origin), direction_)),
        here_(dot(pair(start.origin), direction_)),
        size_(dot(direction_, direction_)),
        point_(pair(start.origin)) {
    for (const std::uint32_t surface : Lander(walls).walls_at(start.origin)) left_ = surface;
  }

  Prospect next() const {
    Prospect found{Prospect::Kind::escape, {}};
    std::vector<Number> best, open;  // places: of what is met first; of what may be missed
    for (std::uint32_t surface = 0; surface < walls_.size(); ++surface) {
      const Meeting meeting = meet(surface);
      if (meeting.met == Met::no) continue;
      if (!meeting.place) return {Prospect::Kind::open, {}};
      if (meeting.met == Met::open) {
        open.push_back(*meeting.place);
        continue;
      }
      const auto order = best.empty() ? Sign::positive : (best.front() - *meeting.place).sign();
      if (!order) return {Prospect::Kind::open, {}};
      if (*order == Sign::negative) continue;
      if (*order == Sign::positive) found.walls.clear();
      const bool alone = found.walls.empty() && meeting.met == Met::between;
      found.kind = alone ? Prospect::Kind::wall : Prospect::Kind::corner;
      found.walls.push_back(surface);
      best.assign(1, *meeting.place);
    }
    for (const Number& place : open)
      if (best.empty() || (place - best.front()).sign() != Sign::positive)
        return {Prospect::Kind::open, {}};
    return found;
  }

  /// Goes on from a wall that the ray is known to meet next; false where Number cannot tell how.
  bool bounce(std::uint32_t surface) {
    const bool known = is_segment(surface) ? bounce_off(segment(surface))
                                           : bounce_off(circle(surface), surface == left_);
    left_ = surface;
    return known;
  }

  /// Where a wall is met that the ray is known to meet next, in a corner.
  std::optional<Pair<Number>> corner_at(std::uint32_t surface) const {
    Flight there(*this);
    if (there.bounce(surface)) return there.point_;
    if (!is_segment(surface)) return std::nullopt;
    const Segment& wall = segment(surface);  // on the line of the ray
    const auto order = (dot(pair(wall.a), direction_) - dot(pair(wall.b), direction_)).sign();
    if (!order) return std::nullopt;
    return pair(*order == Sign::positive ? wall.b : wall.a);
  }

  /// Where the last bounce was.
  const Pair<Number>& point() const { return point_; }
  const Pair<Number>& direction() const { return direction_; }
  /// d.d, which no mirror changes.
  const Number& size() const { return size_; }

 private:
  enum class Met { no, between, end, open };
  struct Meeting {
    Met met;
    std::optional<Number> place;  // nullopt where it is open and may be anywhere
  };

  Pair<Number> pair(const Vec2& v) const { return {make_(v.x()), make_(v.y())}; }

  bool is_segment(std::uint32_t surface) const {
    return walls_.kinds[surface] == SurfaceKind::segment;
  }
  const Segment& segment(std::uint32_t surface) const {
    return walls_.segments[walls_.slot[surface]];
  }
  const Circle& circle(std::uint32_t surface) const { return walls_.circles[walls_.slot[surface]]; }

  Meeting meet(std::uint32_t surface) const {
    if (!is_segment(surface)) return meet_circle(circle(surface), surface == left_);
    return surface == left_ ? Meeting{Met::no, {}} : meet_segment(segment(surface));
  }

  // On which side of the line a point lies: d cross (point - x), that is (x - point) cross d.
  Number side_of(const Vec2& point) const { return cross(direction_, pair(point)) + moment_; }

  Meeting meet_segment(const Segment& wall) const {
    const Number side_a = side_of(wall.a), side_b = side_of(wall.b), apart = side_a - side_b;
    const auto a = side_a.sign(), b = side_b.sign(), slope = apart.sign();
    if (a && a == b && *a != Sign::zero) return {Met::no, {}};
    if (!slope || *slope == Sign::zero) return meet_along(wall, a == Sign::zero && b == Sign::zero);
    const Pair<Number> edge = pair(wall.b) - pair(wall.a);
    const Number place = dot(pair(wall.a), direction_) + side_a / apart * dot(edge, direction_);
    const auto ahead = (place - here_).sign();
    if (ahead == Sign::negative) return {Met::no, {}};
    if (!a || !b || ahead != Sign::positive) return {Met::open, place};
    return {*a == Sign::zero || *b == Sign::zero ? Met::end : Met::between, place};
  }

  // A wall on the line, or so near that it cannot be told: it is met, if it is, between its ends.
  Meeting meet_along(const Segment& wall, bool on_line) const {
    const Number at_a = dot(pair(wall.a), direction_), at_b = dot(pair(wall.b), direction_);
    const auto a = (at_a - here_).sign(), b = (at_b - here_).sign();
    if (a == Sign::negative && b == Sign::negative) return {Met::no, {}};
    const auto order = (at_a - at_b).sign();
    if (!order) return {Met::open, {}};
    const bool surely = on_line && a == Sign::positive && b == Sign::positive;
    return {surely ? Met::end : Met::open, *order == Sign::negative ? at_a : at_b};
  }

  // A circle that the line just meets or misses: if it is met, then within r of its centre.
  Meeting meet_about(const Number& centre, const Circle& wall) const {
    const Number reach = make_(wall.radius) * square_root(size_);
    if ((centre + reach - here_).sign() == Sign::negative) return {Met::no, {}};
    return {Met::open, centre - reach};
  }

  // r^2 d.d - k^2, the square of w.d at points w of length r, seen from the centre, with
  // k = w cross d.
  Number square_of(const Circle& wall) const {
    const Number r = make_(wall.radius), k = side_of(wall.centre);
    return r * r * size_ - k * k;
  }

  Meeting meet_circle(const Circle& wall, bool stood_on) const {
    const Number centre = dot(pair(wall.centre), direction_);
    if (stood_on) {
      const auto leads = (here_ - centre).sign();
      if (leads == Sign::positive || leads == Sign::zero) return {Met::no, {}};
      if (!leads) return {Met::open, {}};
      return {Met::between, centre + centre - here_};
    }
    const Number square = square_of(wall);
    const auto reached = square.sign();
    if (reached == Sign::negative || reached == Sign::zero) return {Met::no, {}};
    if (!reached) return meet_about(centre, wall);
    const Number half = square_root(square);
    for (const Number& place : {centre - half, centre + half}) {
      const auto ahead = (place - here_).sign();
      if (!ahead || *ahead == Sign::zero) return {Met::open, {}};
      if (*ahead == Sign::positive) return {Met::between, place};
    }
    return {Met::no, {}};
  }

  // d' = d - 2 (d.n) n / n.n, a turn of d by known numbers; the moment about a point of the wall
  // changes its sign.
  bool bounce_off(const Segment& wall) {
    const Number side_a = side_of(wall.a), apart = side_a - side_of(wall.b);
    const auto slope = apart.sign();
    if (!slope || *slope == Sign::zero) return false;
    const Pair<Number> edge = pair(wall.b) - pair(wall.a), a = pair(wall.a);
    const Number length = dot(edge, edge), part = side_a / apart;
    const Number c = (edge.x * edge.x - edge.y * edge.y) / length;
    const Number s = make_(2) * edge.x * edge.y / length;
    direction_ = {c * direction_.x + s * direction_.y, s * direction_.x - c * direction_.y};
    moment_ = cross(a, direction_) - side_a;
    here_ = dot(a, direction_) + part * dot(edge, direction_);
    point_ = {a.x + part * edge.x, a.y + part * edge.y};
    return true;
  }

  // With q = w.d and k = w cross d at the point met, d' = (2 k^2 / r^2 d.d - 1) d + 2 q k / r^2 d.d
  // times d turned by a quarter; q changes its sign and k stays.
  bool bounce_off(const Circle& wall, bool stood_on) {
    const Meeting meeting = meet_circle(wall, stood_on);
    if (!meeting.place) return false;
    const Pair<Number> centre = pair(wall.centre), d = direction_;
    const Number q = *meeting.place - dot(centre, d), k = side_of(wall.centre);
    const Number r = make_(wall.radius), scale = r * r * size_;
    const Number c = make_(2) * k * k / scale - make_(1), s = make_(2) * q * k / scale;
    point_ = {centre.x + (q * d.x + k * d.y) / size_, centre.y + (q * d.y - k * d.x) / size_};
    direction_ = {c * d.x - s * d.y, c * d.y + s * d.x};
    moment_ = cross(centre, direction_) + k;
    here_ = dot(centre, direction_) - q;
    return true;
  }

  const Surfaces& walls_;
  Make make_;
  Pair<Number> direction_;
  Number moment_, here_, size_;
  Pair<Number> point_;
  std::uint32_t left_ = kNoSurface;
};

}  // namespace flatray
