#include "study/rooms/wall_places.h"

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "geom/predicates.h"

namespace flatray {
namespace {

constexpr double kTurn = 0x1.921fb54442d18p+2;

// A straight wall by the length from its first end.
class LineWay {
 public:
  explicit LineWay(const Segment& wall) : wall_(wall), sweep_(size_of(wall.b - wall.a)) {}
  double sweep() const { return sweep_; }
  Vec2 at(double past) const { return wall_.a + past / sweep_ * (wall_.b - wall_.a); }
  Vec2 normal_at(const Vec2& point) const { return normal_near(wall_, point) / sweep_; }
  double curvature_at(const Vec2&) const { return 0; }
  double parameter(const Vec2& point) const { return std::min(size_of(point - wall_.a), sweep_); }
  double even_speed() const { return 1; }
  double speed(double) const { return 1; }
  std::vector<Vec2> outline() const { return {wall_.a, wall_.b}; }

 private:
  const Segment& wall_;
  double sweep_;
};

// The length of a short piece of a way: Gauss's rule of 8 places (Abramowitz and Stegun 25.4.30).
template <class Way>
double length_between(const Way& way, double from, double to) {
  constexpr double kPlaces[][2] = {{0.1834346424956498, 0.3626837833783620},
                                   {0.5255324099163290, 0.3137066458778873},
                                   {0.7966664774136267, 0.2223810344533745},
                                   {0.9602898564975363, 0.1012285362903763}};
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  double sum = 0;
  for (const auto& [place, weight] : kPlaces)
    sum += weight * (way.speed(middle - half * place) + way.speed(middle + half * place));
  return std::fabs(half) * sum;
}

// Lengths up to the ends of equal parts of a way, by their parameter; of an even one up to its end.
constexpr std::size_t kPieces = 64;
template <class Way>
std::vector<double> lengths_along(const Way& way) {
  if (way.even_speed() > 0) return {way.even_speed() * std::fabs(way.sweep())};
  std::vector<double> lengths{0};
  const double part = way.sweep() / kPieces;
  for (std::size_t i = 0; i < kPieces; ++i) {
    const auto from = static_cast<double>(i) * part;
    lengths.push_back(lengths.back() + length_between(way, from, from + part));
  }
  return lengths;
}

template <class Way>
double length_to(const Way& way, std::span<const double> lengths, double past) {
  if (way.even_speed() > 0) return way.even_speed() * std::fabs(past);
  const double part = way.sweep() / kPieces;
  const auto i = static_cast<std::size_t>(std::clamp(past / part, 0.0, kPieces - 1.0));
  const double from = static_cast<double>(i) * part;
  return lengths[i] +
         (past / part < static_cast<double>(i) ? -1 : 1) * length_between(way, from, past);
}

// Where on a way `position` is passed: in the part that the lengths say, by Newton's method.
template <class Way>
double passed_at(const Way& way, std::span<const double> lengths, double position) {
  constexpr int kSteps = 5;
  if (way.even_speed() > 0) return (way.sweep() < 0 ? -position : position) / way.even_speed();
  const auto above = std::upper_bound(lengths.begin() + 1, lengths.end() - 1, position);
  const auto i = static_cast<std::size_t>(above - lengths.begin() - 1);
  const double part = way.sweep() / kPieces, from = static_cast<double>(i) * part;
  double share = (position - lengths[i]) / (lengths[i + 1] - lengths[i]);
  for (int step = 0; step < kSteps; ++step) {
    const double at = from + share * part, speed = way.speed(at) * std::fabs(part);
    if (!(speed > 0)) break;
    share += (position - lengths[i] - length_between(way, from, at)) / speed;
    share = std::clamp(share, 0.0, 1.0);
  }
  return from + share * part;
}

// Both ends of a way, and between them places evenly apart in its parameter.
template <class Way>
std::vector<Vec2> evenly_along(const Way& way, int parts) {
  std::vector<Vec2> points;
  for (int i = 0; i <= parts; ++i) points.push_back(way.at(way.sweep() * i / parts));
  return points;
}

// -1 where u, v turn clockwise, else 1.
double turn_of(const Ellipse& curve) {
  return cross_sign(curve.u, curve.v) == Sign::negative ? -1 : 1;
}

// A curved wall by its parameter: centre + cos a u + sin a v, from `from` over `sweep`, which is
// negative where u, v turn clockwise.
class ArcWay {
 public:
  explicit ArcWay(const Arc& arc) : curve_(arc.curve) {
    const double turn = turn_of(curve_) * kTurn;
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
    if (curve_.is_circle()) return direction_of(point - curve_.centre);
    const Vec2 along = tangent_at(point), across(along.y(), -along.x());
    return turn_of(curve_) * across / across.norm();
  }
  double curvature_at(const Vec2& point) const {
    if (curve_.is_circle()) return 1 / curve_.u.x();
    const double fast = tangent_at(point).norm();
    return std::fabs(cross(curve_.u, curve_.v)) / (fast * fast * fast);
  }
  std::vector<Vec2> outline() const { return evenly_along(*this, 96); }
  // The parameter past the beginning of a point near the wall.
  double parameter(const Vec2& point) const {
    const double turn = sweep_ < 0 ? -kTurn : kTurn;
    const double past = angle_of(point - curve_.centre) - from_;
    const double ahead = past * turn < 0 ? past + turn : past;
    // Just before the beginning, by rounding, is the beginning.
    return std::fabs(ahead) > 0.5 * (std::fabs(sweep_) + kTurn) ? 0 : ahead;
  }
  // What lengths are to the parameter, where they are in proportion to it; else 0.
  double even_speed() const { return curve_.is_circle() ? curve_.u.x() : 0; }
  double speed(double past) const { return tangent(past).norm(); }

 private:
  // By the coordinates along u and v of a point, which are the cosine and sine of its parameter.
  Vec2 tangent_at(const Vec2& point) const {
    const Vec2 from = point - curve_.centre;
    const double c = cross(from, curve_.v), s = cross(curve_.u, from);
    return (c * curve_.v - s * curve_.u) * (turn_of(curve_) / std::sqrt(c * c + s * s));
  }
  double angle_of(const Vec2& from) const {
    return portable::atan2(cross(curve_.u, from), cross(from, curve_.v)) +
           (turn_of(curve_) < 0 ? kTurn / 2 : 0);
  }

  Ellipse curve_;
  double from_ = 0, sweep_;
};

// A Bezier curve by its parameter.
class BezierWay {
 public:
  explicit BezierWay(const Bezier& wall) : wall_(wall) {}
  double sweep() const { return 1; }
  Vec2 at(double past) const { return point_at(wall_, past); }
  Vec2 normal_at(const Vec2& point) const { return direction_of(normal_near(wall_, point)); }
  double curvature_at(const Vec2& point) const {
    return flatray::curvature_at(wall_, parameter(point));
  }
  double parameter(const Vec2& point) const { return parameter_near(wall_, point); }
  double even_speed() const { return 0; }
  double speed(double s) const { return speed_at(wall_, s); }
  std::vector<Vec2> outline() const { return evenly_along(*this, 64); }

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

WallPlaces::WallPlaces(const Surfaces& walls) : walls_(walls) {
  for (std::uint32_t i = 0; i < walls.size(); ++i)
    lengths_.push_back(along(walls, i, [](const auto& way) { return lengths_along(way); }));
}

Vec2 WallPlaces::point(std::uint32_t surface, double position) const {
  return along(walls_, surface, [&](const auto& way) {
    return way.at(passed_at(way, lengths_[surface], position));
  });
}

double WallPlaces::position(std::uint32_t surface, const Vec2& point) const {
  return along(walls_, surface, [&](const auto& way) {
    return length_to(way, lengths_[surface], way.parameter(point));
  });
}

Vec2 wall_normal(const Surfaces& walls, std::uint32_t surface, const Vec2& point) {
  return along(walls, surface, [&](const auto& way) { return way.normal_at(point); });
}

double curvature(const Surfaces& walls, std::uint32_t surface, const Vec2& point,
                 const Vec2& normal) {
  if (walls.segment_slot(surface) != kNoSurface) return 0;
  return along(walls, surface, [&](const auto& way) {
    return (way.normal_at(point).dot(normal) > 0 ? 1 : -1) * way.curvature_at(point);
  });
}

std::vector<Vec2> wall_outline(const Surfaces& walls, std::uint32_t surface) {
  return along(walls, surface, [](const auto& way) { return way.outline(); });
}

}  // namespace flatray
