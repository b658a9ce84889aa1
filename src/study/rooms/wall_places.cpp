#include "study/rooms/wall_places.h"

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "geom/decide.h"

namespace flatray {
namespace {

constexpr double kTurn = 0x1.921fb54442d18p+2;

double length(const Vec2& v) { return std::sqrt(v.x() * v.x() + v.y() * v.y()); }

// A straight wall by the length from its first end.
class LineWay {
 public:
  explicit LineWay(const Segment& wall) : wall_(wall), sweep_(length(wall.b - wall.a)) {}
  double sweep() const { return sweep_; }
  Vec2 at(double past) const { return wall_.a + past / sweep_ * (wall_.b - wall_.a); }
  Vec2 normal_at(const Vec2& point) const { return normal_near(wall_, point) / sweep_; }
  double curvature_at(const Vec2&) const { return 0; }
  double parameter(const Vec2& point) const { return length(point - wall_.a); }
  double length_to(double past) const { return std::min(past, sweep_); }
  double parameter_at(double position) const { return position; }
  std::vector<Vec2> outline() const { return {wall_.a, wall_.b}; }

 private:
  const Segment& wall_;
  double sweep_;
};

// The length of a way at a speed, up to a parameter. Simpson's rule: as exact as doubles for what is smooth and
// periodic, near it elsewhere.
template <class Speed>
double length_at(const Speed& speed, double past) {
  constexpr int kParts = 256;
  double sum = speed(0.0) + speed(past);
  for (int i = 1; i < kParts; ++i) sum += (i % 2 == 1 ? 4 : 2) * speed(past * i / kParts);
  return sum * std::fabs(past) / (3 * kParts);
}

// Where on a way `position` is passed, by bisection.
template <class Way>
double passed_at(const Way& way, double position) {
  double low = 0, high = 1;
  for (int i = 0; i < 52; ++i) {
    const double middle = 0.5 * (low + high);
    (way.length_to(middle * way.sweep()) < position ? low : high) = middle;
  }
  return low * way.sweep();
}

// A curved wall by its parameter: centre + cos a u + sin a v, from `from` over `sweep`, which is
// negative where u, v turn clockwise.
class ArcWay {
 public:
  explicit ArcWay(const Arc& arc) : curve_(arc.curve) {
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
  Vec2 normal_at(const Vec2& point) const {
    if (curve_.is_circle()) {
      const Vec2 out = point - curve_.centre;
      return out / flatray::length(out);
    }
    const Vec2 along = tangent(parameter(point)), across(along.y(), -along.x());
    return (cross(curve_.u, curve_.v) < 0 ? -1 : 1) * across / flatray::length(across);
  }
  double curvature_at(const Vec2& point) const {
    if (curve_.is_circle()) return 1 / curve_.u.x();
    const double fast = speed(parameter(point));
    return std::fabs(cross(curve_.u, curve_.v)) / (fast * fast * fast);
  }
  std::vector<Vec2> outline() const {
    constexpr int kParts = 96;
    std::vector<Vec2> points;
    for (int i = 0; i <= kParts; ++i) points.push_back(at(sweep_ * i / kParts));
    return points;
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
    return length_at([this](double at) { return speed(at); }, past);
  }
  double parameter_at(double position) const {
    if (curve_.is_circle()) return (sweep_ < 0 ? -position : position) / curve_.u.x();
    return passed_at(*this, position);
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

// A Bezier curve by its parameter.
class BezierWay {
 public:
  explicit BezierWay(const Bezier& wall) : wall_(wall) {}
  double sweep() const { return 1; }
  Vec2 at(double past) const { return point_at(wall_, past); }
  Vec2 normal_at(const Vec2& point) const {
    const Vec2 normal = normal_near(wall_, point);
    return normal / length(normal);
  }
  double curvature_at(const Vec2& point) const {
    const double s = parameter(point);
    const auto bend = [&](int axis) {
      const auto rates = bernstein_derivative(coordinates_of(kPlain, wall_, axis));
      return bernstein_value(bernstein_derivative(rates), s);
    };
    const Vec2 rate = tangent_at(wall_, s);
    const double speed = length(rate);
    return std::fabs(cross(rate, Vec2(bend(0), bend(1)))) / (speed * speed * speed);
  }
  double parameter(const Vec2& point) const { return parameter_near(wall_, point); }
  double length_to(double past) const {
    return length_at([this](double s) { return length(tangent_at(wall_, s)); }, past);
  }
  double parameter_at(double position) const { return passed_at(*this, position); }
  std::vector<Vec2> outline() const {
    constexpr int kParts = 64;
    std::vector<Vec2> points;
    for (int i = 0; i <= kParts; ++i) points.push_back(at(static_cast<double>(i) / kParts));
    return points;
  }

 private:
  const Bezier& wall_;
};

LineWay way_along(const Segment& wall) { return LineWay(wall); }
ArcWay way_along(const Arc& wall) { return ArcWay(wall); }
BezierWay way_along(const Bezier& wall) { return BezierWay(wall); }

// What `use` makes of the way along a wall.
template <class Use>
auto along(const Surfaces& walls, std::uint32_t surface, const Use& use) {
  return walls.visit(surface, [&](const auto& wall) { return use(way_along(wall)); });
}

}  // namespace

double wall_length(const Surfaces& walls, std::uint32_t surface) {
  return along(walls, surface, [](const auto& way) { return way.length_to(way.sweep()); });
}

Vec2 wall_point(const Surfaces& walls, std::uint32_t surface, double position) {
  return along(walls, surface, [&](const auto& way) { return way.at(way.parameter_at(position)); });
}

double wall_position(const Surfaces& walls, std::uint32_t surface, const Vec2& point) {
  return along(walls, surface,
               [&](const auto& way) { return way.length_to(way.parameter(point)); });
}

Vec2 wall_normal(const Surfaces& walls, std::uint32_t surface, const Vec2& point) {
  return along(walls, surface, [&](const auto& way) { return way.normal_at(point); });
}

double curvature(const Surfaces& walls, std::uint32_t surface, const Vec2& point,
                 const Vec2& normal) {
  return along(walls, surface, [&](const auto& way) {
    return (way.normal_at(point).dot(normal) > 0 ? 1 : -1) * way.curvature_at(point);
  });
}

std::vector<Vec2> wall_outline(const Surfaces& walls, std::uint32_t surface) {
  return along(walls, surface, [](const auto& way) { return way.outline(); });
}

}  // namespace flatray
