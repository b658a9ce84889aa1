#include "transport/exact_hit.h"

#include "geom/decide.h"

namespace flatray {
namespace {

const auto kBounded = [](double x) { return Bounded(x); };
const auto kRational = [](double x) { return Rational(x); };

Rational square(const Rational& x) { return x * x; }

// |o - c|^2 - r^2 of the origin of a ray, and half of what t adds to it: (o - c).d
Rational power(const Ray& ray, const Vec2& centre, double radius) {
  return square(Rational(ray.origin.x()) - centre.x()) +
         square(Rational(ray.origin.y()) - centre.y()) - square(radius);
}
Rational approach(const Ray& ray, const Vec2& centre) {
  return (Rational(ray.origin.x()) - centre.x()) * ray.direction.x() +
         (Rational(ray.origin.y()) - centre.y()) * ray.direction.y();
}

}  // namespace

// constant + slope * t
struct ExactHit::LinearForm {
  Rational constant, slope;
};

// t = numer / denom as in eq. 3 of the paper. A wall parallel to an axis gives one coordinate
// without error, where 0 +- an error would need the rationals.
ExactHit::ExactHit(const Ray& ray, const Segment& wall)
    : ray_(ray), time_(HitTime::on_line(ray, wall)) {
  const Bounded t = determinant(kBounded, ray.origin, wall.a, wall.a, wall.b) /
                    determinant(kBounded, Vec2(0, 0), ray.direction, wall.a, wall.b);
  const auto coordinate = [&](int axis) {
    if (wall.a[axis] == wall.b[axis]) return Bounded(wall.a[axis]);
    return Bounded(ray.origin[axis]) + Bounded(ray.direction[axis]) * t;
  };
  x_ = coordinate(0);
  y_ = coordinate(1);
}

// The foot of the perpendicular from the centre to the ray is k d' / d.d with d' = (-d_y, d_x), k =
// d x w and w = o - c; from there the point lies along the ray, by d / d.d times the root of r^2
// d.d - k^2.
ExactHit::ExactHit(const Ray& ray, const Circle& wall, Root root)
    : ray_(ray),
      time_(HitTime::on_circle(ray, wall,
                               root == Root::first ? HitTime::Root::first : HitTime::Root::second)),
      centre_(wall.centre),
      radius_(wall.radius),
      root_(root == Root::first ? -1 : 1) {
  const Bounded dx = ray.direction.x(), dy = ray.direction.y(), r = wall.radius;
  const Bounded wx = Bounded(ray.origin.x()) - wall.centre.x();
  const Bounded wy = Bounded(ray.origin.y()) - wall.centre.y();
  const Bounded size = dx * dx + dy * dy, k = dx * wy - dy * wx;
  const Bounded length = square_root(r * r * size - k * k), s = root_;
  x_ = (s * dx * length - k * dy) / size;
  y_ = (s * dy * length + k * dx) / size;
}

// o + t d by t = (p + s sqrt(q)) / a.
double ExactHit::exactly_rounded(const Vec2& centre, int axis) const {
  const HitTime::Exact t = time_.exact();
  const Rational speed = Rational(ray_.direction[axis]) / t.a;
  const Rational from = Rational(ray_.origin[axis]) - centre_[axis] + centre[axis];
  return Rational::root_sum(from + speed * t.p, t.s * static_cast<int>(speed.sign()),
                            speed * speed * t.q);
}

Vec2 ExactHit::rounded(const Vec2& centre) const {
  const auto x = (Bounded(centre.x()) + x_).nearest(), y = (Bounded(centre.y()) + y_).nearest();
  return {x ? *x : exactly_rounded(centre, 0), y ? *y : exactly_rounded(centre, 1)};
}

Sign ExactHit::sign(const LinearForm& form) const {
  const HitTime::Exact t = time_.exact();
  return Rational::root_sign(form.constant * t.a + form.slope * t.p,
                             t.s * static_cast<int>(form.slope.sign()),
                             form.slope * form.slope * t.q);
}

Sign ExactHit::side_of(const Segment& segment) const {
  const Bounded ex = Bounded(segment.b.x()) - segment.a.x();
  const Bounded ey = Bounded(segment.b.y()) - segment.a.y();
  const Bounded x = Bounded(centre_.x()) - segment.a.x() + x_;
  const Bounded y = Bounded(centre_.y()) - segment.a.y() + y_;
  if (const auto sign = (ex * y - ey * x).sign()) return *sign;
  return this->sign({determinant(kRational, segment.a, segment.b, segment.a, ray_.origin),
                     determinant(kRational, segment.a, segment.b, Vec2(0, 0), ray_.direction)});
}

Sign ExactHit::side_of(const Circle& circle) const {
  const Bounded x = Bounded(centre_.x()) - circle.centre.x() + x_, r = circle.radius;
  const Bounded y = Bounded(centre_.y()) - circle.centre.y() + y_;
  if (const auto sign = (x * x + y * y - r * r).sign()) return *sign;
  const Rational here = power(ray_, circle.centre, circle.radius);
  const Rational rate = approach(ray_, circle.centre);
  if (root_ != 0)  // less the same of its own circle, which is 0: linear in t
    return this->sign(
        {here - power(ray_, centre_, radius_), Rational(2) * (rate - approach(ray_, centre_))});
  const HitTime::Exact time = time_.exact();
  const Rational t = time.p / time.a;
  const Rational size = square(ray_.direction.x()) + square(ray_.direction.y());
  return (here + t * (Rational(2) * rate + t * size)).sign();
}

bool ExactHit::on(const Segment& segment) const {
  if (side_of(segment) != Sign::zero) return false;
  // Between the ends, along the segment: (H - a).(b - a) >= 0 and (H - b).(a - b) >= 0.
  const auto ahead = [&](const Vec2& from, const Vec2& to) {
    const Rational ex = Rational(to.x()) - from.x(), ey = Rational(to.y()) - from.y();
    return sign({(Rational(ray_.origin.x()) - from.x()) * ex +
                     (Rational(ray_.origin.y()) - from.y()) * ey,
                 Rational(ray_.direction.x()) * ex + Rational(ray_.direction.y()) * ey}) !=
           Sign::negative;
  };
  return ahead(segment.a, segment.b) && ahead(segment.b, segment.a);
}

}  // namespace flatray
