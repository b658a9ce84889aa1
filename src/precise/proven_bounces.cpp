#include "precise/proven_bounces.h"

#include "geom/bounded.h"
#include "trace/on_surface.h"

namespace flatray {
namespace {

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

// A ray as a line x: x cross d = m, which mirrors turn without a division, so that errors between
// straight walls only add up. Places on it count by tau = x.d, times by tau / d.d.
template <class Number>
class Flight {
 public:
  Flight(const Surfaces& walls, const Ray& start)
      : walls_(walls),
        direction_(pair(start.direction)),
        moment_(cross(pair(start.origin), direction_)),
        here_(dot(pair(start.origin), direction_)),
        size_(dot(direction_, direction_)) {}

  // Where the ray starts on a wall it has left that one.
  void leave(std::uint32_t surface) { left_ = surface; }

  // The wall met next, where it is certain.
  std::optional<std::uint32_t> next() const {
    std::optional<std::uint32_t> first;
    std::vector<Number> best, open;  // places: of the first wall; of those that may be missed
    for (std::uint32_t surface = 0; surface < walls_.size(); ++surface) {
      const Meeting meeting = meet(surface);
      if (meeting.met == Met::no) continue;
      if (!meeting.place) return std::nullopt;
      if (meeting.met == Met::open) {
        open.push_back(*meeting.place);
        continue;
      }
      if (!best.empty()) {
        const auto order = (best.front() - *meeting.place).sign();
        if (!order || *order == Sign::zero) return std::nullopt;
        if (*order == Sign::negative) continue;
      }
      best.assign(1, *meeting.place);
      first = surface;
    }
    for (const Number& place : open)
      if (best.empty() || (place - best.front()).sign() != Sign::positive) return std::nullopt;
    return first;
  }

  // Goes on from a wall that the ray is known to meet next; false where Number cannot tell how.
  bool bounce(std::uint32_t surface) {
    const bool known = is_segment(surface) ? bounce_off(segment(surface))
                                           : bounce_off(circle(surface), surface == left_);
    left_ = surface;
    return known;
  }

 private:
  enum class Met { no, yes, open };
  struct Meeting {
    Met met;
    std::optional<Number> place;  // nullopt where it is open and may be anywhere
  };

  static Pair<Number> pair(const Vec2& v) { return {Number(v.x()), Number(v.y())}; }

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
    if (!slope || *slope == Sign::zero) return {Met::open, {}};
    const Pair<Number> edge = pair(wall.b) - pair(wall.a);
    const Number place = dot(pair(wall.a), direction_) + side_a / apart * dot(edge, direction_);
    const auto ahead = (place - here_).sign();
    if (ahead == Sign::negative) return {Met::no, {}};
    const bool crossed = a && b && *a != Sign::zero && *b != Sign::zero;
    return {crossed && ahead == Sign::positive ? Met::yes : Met::open, place};
  }

  // r^2 d.d - k^2, the square of w.d at points w of length r, seen from the centre, with k = w cross d.
  Number square_of(const Circle& wall) const {
    const Number r(wall.radius), k = side_of(wall.centre);
    return r * r * size_ - k * k;
  }

  Meeting meet_circle(const Circle& wall, bool stood_on) const {
    const Number centre = dot(pair(wall.centre), direction_), square = square_of(wall);
    if (stood_on) {
      const auto leads = (here_ - centre).sign();
      if (leads == Sign::positive || leads == Sign::zero) return {Met::no, {}};
      if (!leads) return {Met::open, {}};
      return {Met::yes, centre + centre - here_};
    }
    const auto reached = square.sign();
    if (reached == Sign::negative || reached == Sign::zero) return {Met::no, {}};
    if (!reached) return {Met::open, {}};
    const Number half = square_root(square);
    for (const Number& place : {centre - half, centre + half}) {
      const auto ahead = (place - here_).sign();
      if (!ahead || *ahead == Sign::zero) return {Met::open, {}};
      if (*ahead == Sign::positive) return {Met::yes, place};
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
    const Number length = dot(edge, edge);
    const Number c = (edge.x * edge.x - edge.y * edge.y) / length;
    const Number s = Number(2) * edge.x * edge.y / length;
    direction_ = {c * direction_.x + s * direction_.y, s * direction_.x - c * direction_.y};
    moment_ = cross(a, direction_) - side_a;
    here_ = dot(a, direction_) + side_a / apart * dot(edge, direction_);
    return true;
  }

  // With q = w.d and k = w cross d at the point met, d' = (2 k^2 / r^2 d.d - 1) d + 2 q k / r^2 d.d
  // times d turned by a quarter; q changes its sign and k stays.
  bool bounce_off(const Circle& wall, bool stood_on) {
    const Meeting meeting = meet_circle(wall, stood_on);
    if (!meeting.place) return false;
    const Pair<Number> centre = pair(wall.centre);
    const Number q = *meeting.place - dot(centre, direction_), k = side_of(wall.centre);
    const Number r(wall.radius), scale = r * r * size_;
    const Number c = Number(2) * k * k / scale - Number(1), s = Number(2) * q * k / scale;
    direction_ = {c * direction_.x - s * direction_.y, c * direction_.y + s * direction_.x};
    moment_ = cross(centre, direction_) + k;
    here_ = dot(centre, direction_) - q;
    return true;
  }

  const Surfaces& walls_;
  Pair<Number> direction_;
  Number moment_, here_, size_;
  std::uint32_t left_ = kNoSurface;
};

bool stands_on(const Surfaces& walls, std::uint32_t surface, const Vec2& point) {
  const std::uint32_t slot = walls.slot[surface];
  if (walls.kinds[surface] == SurfaceKind::segment) return lies_on(point, walls.segments[slot]);
  return circle_side(point, walls.circles[slot]) == Sign::zero;
}

}  // namespace

std::uint64_t proven_bounces(const Surfaces& walls, const Orbit& orbit) {
  if (orbit.bounces.empty()) return 0;
  Flight<Bounded> flight(walls, {orbit.start, orbit.direction});
  for (std::uint32_t surface = 0; surface < walls.size(); ++surface)
    if (stands_on(walls, surface, orbit.start)) flight.leave(surface);
  // The first hit was decided without rounding.
  std::uint64_t proven = 1;
  for (; proven < orbit.bounces.size(); ++proven) {
    const std::uint32_t last = orbit.bounces[proven - 1].surface;
    if (!flight.bounce(last)) return proven;
    if (flight.next() != orbit.bounces[proven].surface) return proven;
  }
  return proven;
}

}  // namespace flatray
