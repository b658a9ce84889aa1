#include "study/wall_places.h"

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"

namespace flatray {
namespace {

constexpr double kTurn = 0x1.921fb54442d18p+2;

const Segment& segment(const Surfaces& walls, std::uint32_t surface) {
  return walls.segments[walls.slot[surface]];
}
double length(const Vec2& v) { return std::sqrt(v.x() * v.x() + v.y() * v.y()); }

// A curved wall by its parameter: centre + cos a u + sin a v, from `from` over `sweep`, which is
// negative where u, v turn clockwise.
class Way {
 public:
  explicit Way(const Arc& arc) : curve_(arc.curve) {
    const double turn = cross(curve_.u, curve_.v) < 0 ? -kTurn : kTurn;
    sweep_ = turn;
    if (arc.extent == Arc::Extent::whole) return;
    const bool half = arc.extent == Arc::Extent::half;
    from_ = angle_of(half ? Vec2(arc.from.y(), -arc.from.x()) : Vec2(arc.from - curve_.centre));
    const double to =
        angle_of(half ? Vec2(-arc.from.y(), arc.from.x()) : Vec2(arc.to - curve_.centre));
    sweep_ = to - from_;
    if (sweep_ * turn < 0) sweep_ += turn;
  }
  double sweep() const { return sweep_; }
  Vec2 at(double past) const {
    const double a = from_ + past;
    return curve_.centre + portable::cos(a) * curve_.u + portable::sin(a) * curve_.v;
  }
  Vec2 tangent(double past) const {
    const double a = from_ + past;
    return portable::cos(a) * curve_.v - portable::sin(a) * curve_.u;
  }
  // The parameter past the beginning of a point near the wall.
  double parameter(const Vec2& point) const {
    const double turn = sweep_ < 0 ? -kTurn : kTurn;
    const double past = angle_of(point - curve_.centre) - from_;
    const double ahead = past * turn < 0 ? past + turn : past;
    // Just before the beginning, by rounding, is the beginning.
    return std::fabs(ahead) > 0.5 * (std::fabs(sweep_) + kTurn) ? 0 : ahead;
  }
  double length_to(double past) const {
    if (curve_.is_circle()) return curve_.u.x() * std::fabs(past);
    // Simpson's rule: as exact as doubles for what is smooth and periodic, near it elsewhere.
    constexpr int kParts = 256;
    double sum = speed(0) + speed(past);
    for (int i = 1; i < kParts; ++i) sum += (i % 2 == 1 ? 4 : 2) * speed(past * i / kParts);
    return sum * std::fabs(past) / (3 * kParts);
  }
  // Where on the way `position` is passed.
  double parameter_at(double position) const {
    if (curve_.is_circle()) return (sweep_ < 0 ? -position : position) / curve_.u.x();
    double low = 0, high = 1;
    for (int i = 0; i < 52; ++i) {
      const double middle = 0.5 * (low + high);
      (length_to(middle * sweep_) < position ? low : high) = middle;
    }
    return low * sweep_;
  }

 private:
  double angle_of(const Vec2& from) const {
    return portable::atan2(cross(curve_.u, from), cross(from, curve_.v)) +
           (cross(curve_.u, curve_.v) < 0 ? kTurn / 2 : 0);
  }
  double speed(double past) const { return flatray::length(tangent(past)); }

  Ellipse curve_;
  double from_ = 0, sweep_;
};

Way way_along(const Surfaces& walls, std::uint32_t surface) { return Way(walls.arc(surface)); }

}  // namespace

double wall_length(const Surfaces& walls, std::uint32_t surface) {
  if (!walls.is_straight(surface)) {
    const Way way = way_along(walls, surface);
    return way.length_to(way.sweep());
  }
  const Segment& wall = segment(walls, surface);
  return length(wall.b - wall.a);
}

Vec2 wall_point(const Surfaces& walls, std::uint32_t surface, double position) {
  if (!walls.is_straight(surface)) {
    const Way way = way_along(walls, surface);
    return way.at(way.parameter_at(position));
  }
  const Segment& wall = segment(walls, surface);
  return wall.a + position / wall_length(walls, surface) * (wall.b - wall.a);
}

double wall_position(const Surfaces& walls, std::uint32_t surface, const Vec2& point) {
  if (!walls.is_straight(surface)) {
    const Way way = way_along(walls, surface);
    return way.length_to(way.parameter(point));
  }
  return std::min(length(point - segment(walls, surface).a), wall_length(walls, surface));
}

Vec2 wall_normal(const Surfaces& walls, std::uint32_t surface, const Vec2& point) {
  if (!walls.is_straight(surface)) {
    const Ellipse curve = walls.curve(surface);
    if (curve.is_circle()) {
      const Vec2 out = point - curve.centre;
      return out / length(out);
    }
    const Way way = way_along(walls, surface);
    const Vec2 along = way.tangent(way.parameter(point));
    const Vec2 across(along.y(), -along.x());
    return (cross(curve.u, curve.v) < 0 ? -1 : 1) * across / length(across);
  }
  const Segment& wall = segment(walls, surface);
  const Vec2 edge = wall.b - wall.a;
  return Vec2(-edge.y(), edge.x()) / length(edge);
}

double curvature(const Surfaces& walls, std::uint32_t surface, const Vec2& point,
                 const Vec2& normal) {
  if (walls.is_straight(surface)) return 0;
  const Ellipse curve = walls.curve(surface);
  const int sign = wall_normal(walls, surface, point).dot(normal) > 0 ? 1 : -1;
  if (curve.is_circle()) return sign / curve.u.x();
  const Way way = way_along(walls, surface);
  const double speed = length(way.tangent(way.parameter(point)));
  return sign * std::fabs(cross(curve.u, curve.v)) / (speed * speed * speed);
}

std::vector<Vec2> wall_outline(const Surfaces& walls, std::uint32_t surface) {
  if (walls.is_straight(surface)) return {segment(walls, surface).a, segment(walls, surface).b};
  constexpr int kParts = 96;
  const Way way = way_along(walls, surface);
  std::vector<Vec2> points;
  for (int i = 0; i <= kParts; ++i) points.push_back(way.at(way.sweep() * i / kParts));
  return points;
}

}  // namespace flatray
