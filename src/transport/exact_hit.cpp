#include "transport/exact_hit.h"

#include <cmath>

#include "geom/decide.h"

namespace flatray {
namespace {

const auto kBounded = [](double x) { return Bounded(x); };
const auto kRational = [](double x) { return Rational(x); };

// o + t d on one axis, with t = numer / denom as in eq. 3 of the paper.
template <class Make>
auto on_line(const Make& number, const Ray& ray, const Segment& wall, int axis) {
  const Vec2 zero(0, 0);
  return number(ray.origin[axis]) + number(ray.direction[axis]) *
                                        determinant(number, ray.origin, wall.a, wall.a, wall.b) /
                                        determinant(number, zero, ray.direction, wall.a, wall.b);
}

// A point of a circle seen from its centre, on one axis: foot + root * sqrt(square). The foot is
// that of the perpendicular from the centre to the ray, k d' / d.d with d' = (-d_y, d_x) and k = d
// x w, w = o - c; the root goes along the ray from there, d / d.d times sqrt(r^2 d.d - k^2).
template <class Number>
struct Chord {
  Number foot, along, square;
};
template <class Make>
auto chord(const Make& number, const Ray& ray, const Circle& circle, int axis) {
  const auto dx = number(ray.direction.x()), dy = number(ray.direction.y());
  const auto wx = number(ray.origin.x()) - number(circle.centre.x());
  const auto wy = number(ray.origin.y()) - number(circle.centre.y());
  const auto size = dx * dx + dy * dy, k = dx * wy - dy * wx, r = number(circle.radius);
  using Number = std::remove_const_t<decltype(size)>;
  return Chord<Number>{k * (axis == 0 ? -dy : dx) / size, (axis == 0 ? dx : dy) / size,
                       r * r * size - k * k};
}

// `from` + the chord's end, rounded once.
double chord_end(const Ray& ray, const Circle& circle, int root, int axis, double from) {
  const auto fast = chord(kBounded, ray, circle, axis);
  const Bounded length = fast.along * square_root(fast.square);
  if (const auto rounded = (Bounded(from) + fast.foot + (root < 0 ? -length : length)).nearest())
    return *rounded;
  const auto exact = chord(kRational, ray, circle, axis);
  return Rational::root_sum(Rational(from) + exact.foot,
                            root * static_cast<int>(exact.along.sign()),
                            exact.along * exact.along * exact.square);
}

double line_point(const Ray& ray, const Segment& wall, int axis) {
  if (const auto rounded = on_line(kBounded, ray, wall, axis).nearest()) return *rounded;
  return on_line(kRational, ray, wall, axis).nearest();
}

}  // namespace

// constant + slope * t
struct ExactHit::LinearForm {
  Rational constant, slope;
};

ExactHit::ExactHit(const Ray& ray, const Segment& wall)
    : ray_(ray), on_circle_(false), segment_(wall), time_(HitTime::on_line(ray, wall)) {}

ExactHit::ExactHit(const Ray& ray, const Circle& wall, Root root)
    : ray_(ray),
      on_circle_(true),
      circle_(wall),
      root_(root == Root::first ? -1 : 1),
      time_(HitTime::on_circle(
          ray, wall, root == Root::first ? HitTime::Root::first : HitTime::Root::second)) {}

Vec2 ExactHit::nearest() const {
  if (!on_circle_) return {line_point(ray_, segment_, 0), line_point(ray_, segment_, 1)};
  return {chord_end(ray_, circle_, root_, 0, circle_.centre.x()),
          chord_end(ray_, circle_, root_, 1, circle_.centre.y())};
}

Vec2 ExactHit::from_centre() const {
  return {chord_end(ray_, circle_, root_, 0, 0), chord_end(ray_, circle_, root_, 1, 0)};
}

// t = (p + s sqrt(q)) / a with a > 0.
Sign ExactHit::sign(const LinearForm& form) const {
  const HitTime::Exact t = time_.exact();
  const int s = t.s * static_cast<int>(form.slope.sign());
  return Rational::root_sign(form.constant * t.a + form.slope * t.p, s,
                             form.slope * form.slope * t.q);
}

Sign ExactHit::side_of(const Segment& segment) const {
  const Vec2 zero(0, 0);
  return sign({determinant(kRational, segment.a, segment.b, segment.a, ray_.origin),
               determinant(kRational, segment.a, segment.b, zero, ray_.direction)});
}

Sign ExactHit::side_of(const Circle& circle) const {
  const auto square = [](const Rational& x) { return x * x; };
  const auto power = [&](const Vec2& centre, double radius) {  // of the origin
    return square(Rational(ray_.origin.x()) - centre.x()) +
           square(Rational(ray_.origin.y()) - centre.y()) - square(radius);
  };
  const auto slope = [&](const Vec2& centre) {
    return Rational(2) * ((Rational(ray_.origin.x()) - centre.x()) * ray_.direction.x() +
                          (Rational(ray_.origin.y()) - centre.y()) * ray_.direction.y());
  };
  if (on_circle_)  // |H - c|^2 - r^2 less the same of its own circle, which is 0: linear in t
    return sign({power(circle.centre, circle.radius) - power(circle_.centre, circle_.radius),
                 slope(circle.centre) - slope(circle_.centre)});
  const HitTime::Exact time = time_.exact();
  const Rational t = time.p / time.a;
  const Rational size = square(ray_.direction.x()) + square(ray_.direction.y());
  return (power(circle.centre, circle.radius) + t * (slope(circle.centre) + t * size)).sign();
}

bool ExactHit::on(const Segment& segment) const {
  if (side_of(segment) != Sign::zero) return false;
  // Between the ends, along the segment: (H - a).(b - a) >= 0 and (H - b).(a - b) >= 0.
  const auto ahead = [&](const Vec2& from, const Vec2& to) {
    const Rational ex = Rational(to.x()) - from.x(), ey = Rational(to.y()) - from.y();
    return sign(
        {(Rational(ray_.origin.x()) - from.x()) * ex + (Rational(ray_.origin.y()) - from.y()) * ey,
         Rational(ray_.direction.x()) * ex + Rational(ray_.direction.y()) * ey});
  };
  return ahead(segment.a, segment.b) != Sign::negative &&
         ahead(segment.b, segment.a) != Sign::negative;
}

}  // namespace flatray
