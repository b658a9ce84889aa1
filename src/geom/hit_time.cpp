#include "geom/hit_time.h"

#include <limits>
#include <type_traits>

#include "geom/decide.h"

namespace flatray {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();

const auto kBounded = [](double x) { return Bounded(x); };
const auto kRational = [](double x) { return Rational(x); };

// t = numer / denom on a line, as in eq. 3 of the paper; `Number` is Bounded or Rational.
template <class Number>
struct LineTime {
  Number numer, denom;
};
template <class Make, class Number = std::invoke_result_t<Make, double>>
LineTime<Number> line_time(const Make& number, const Ray& ray, const Vec2& p, const Vec2& from,
                           const Vec2& to, const Vec2& velocity) {
  return {determinant(number, ray.origin, p, from, to),
          determinant(number, velocity, ray.direction, from, to)};
}

// t = (b +- sqrt(q)) / a on a circle.
template <class Number>
struct CircleTime {
  Number a, b, q;
  Number outside;  // |centre - origin|^2 - r^2: the product of the roots, times a
};
template <class Make, class Number = std::invoke_result_t<Make, double>>
CircleTime<Number> circle_time(const Make& number, const Ray& ray, const Vec2& centre,
                               double radius) {
  const auto dx = number(ray.direction.x()), dy = number(ray.direction.y());
  const auto wx = number(centre.x()) - number(ray.origin.x());
  const auto wy = number(centre.y()) - number(ray.origin.y());
  const auto r2 = number(radius) * number(radius), a = dx * dx + dy * dy, k = dx * wy - dy * wx;
  return {a, dx * wx + dy * wy, r2 * a - k * k, wx * wx + wy * wy - r2};
}

// Sign of a + s1 sqrt(q1) + s2 sqrt(q2).
Sign two_root_sign(const Rational& a, int s1, const Rational& q1, int s2, const Rational& q2) {
  if (s1 == 0) return Rational::root_sign(a, s2, q2);
  if (s2 == 0) return Rational::root_sign(a, s1, q1);
  const auto larger = q1 <=> q2;
  const Sign roots = static_cast<Sign>(s1 == s2 || larger > 0 ? s1 : larger < 0 ? s2 : 0);
  if (roots == Sign::zero) return a.sign();
  if (a.sign() == Sign::zero || a.sign() == roots) return roots;
  // They differ in sign: compare a^2 with the square of the roots' sum.
  return a.sign() * Rational::root_sign(a * a - q1 - q2, -s1 * s2, Rational(4) * q1 * q2);
}

}  // namespace

HitTime HitTime::on_line(const Ray& ray, const Vec2& p, const Vec2& from, const Vec2& to) {
  HitTime time;
  time.ray_ = ray;
  time.p_ = p;
  time.from_ = from;
  time.to_ = to;
  return time;
}

HitTime HitTime::on_moving_line(const Ray& ray, const Vec2& p, const Vec2& from, const Vec2& to,
                                const Vec2& velocity) {
  HitTime time = on_line(ray, p, from, to);
  time.velocity_ = velocity;
  return time;
}

HitTime HitTime::on_circle(const Ray& ray, const Circle& circle, Root root) {
  HitTime time;
  time.ray_ = ray;
  time.p_ = circle.centre;
  time.radius_ = circle.radius;
  time.root_ = static_cast<int>(root);
  return time;
}

Sign HitTime::sign() const { return sign_of(compare(0)); }

std::strong_ordering HitTime::compare(double other) const {
  if (std::isinf(other)) return 0 <=> (other > 0 ? 1 : -1);
  if (root_ == 0) {
    const Sign denom = cross_sign(velocity_, ray_.direction, from_, to_);
    if (other == 0) return order(cross_sign(ray_.origin, p_, from_, to_) * denom);
    const auto ahead = [&](const auto& number) {
      const auto time = line_time(number, ray_, p_, from_, to_, velocity_);
      return time.numer - number(other) * time.denom;
    };
    return order(decide(ahead) * denom);
  }
  // Between the roots the point at `other` is inside the circle; outside, the mid-point of the
  // chord tells the side.
  const Sign outside = decide([&](const auto& number) {
    const auto x =
        number(ray_.origin.x()) + number(other) * number(ray_.direction.x()) - number(p_.x());
    const auto y =
        number(ray_.origin.y()) + number(other) * number(ray_.direction.y()) - number(p_.y());
    return x * x + y * y - number(radius_) * number(radius_);
  });
  if (outside == Sign::negative) return order(static_cast<Sign>(root_));
  const Sign middle = decide([&](const auto& number) {
    const auto time = circle_time(number, ray_, p_, radius_);
    return time.b - number(other) * time.a;
  });
  if (outside == Sign::zero && static_cast<int>(middle) != root_)
    return std::strong_ordering::equal;
  return order(middle);
}

Bounded HitTime::approximate() const {
  if (root_ == 0) {
    const auto time = line_time(kBounded, ray_, p_, from_, to_, velocity_);
    return time.numer / time.denom;
  }
  const auto time = circle_time(kBounded, ray_, p_, radius_);
  const Bounded root = root_ > 0 ? square_root(time.q) : -square_root(time.q);
  // b and the root may cancel: then the other root and the product of both.
  if ((time.b.hi() > 0) == (root_ > 0)) return (time.b + root) / time.a;
  return time.outside / (time.b - root);
}

HitTime::Exact HitTime::exact() const {
  if (root_ == 0) {
    auto time = line_time(kRational, ray_, p_, from_, to_, velocity_);
    if (time.denom.sign() == Sign::negative) return {-time.numer, 0, 0, -time.denom};
    return {std::move(time.numer), 0, 0, std::move(time.denom)};
  }
  auto time = circle_time(kRational, ray_, p_, radius_);
  const int s = time.q.sign() == Sign::zero ? 0 : root_;
  return {std::move(time.b), s, std::move(time.q), std::move(time.a)};
}

RoundedTime HitTime::nearest() const {
  const auto rounded = approximate().nearest();
  if (rounded && std::fabs(*rounded) < kLargest) return {*rounded, false};
  const Exact time = exact();
  const double t = Rational::root_sum(time.p / time.a, time.s, time.q / (time.a * time.a));
  if (compare(kLargest) > 0) return {kLargest, true};
  if (compare(-kLargest) < 0) return {-kLargest, true};
  return {t, false};
}

std::strong_ordering compare(const HitTime& a, const HitTime& b) {
  if (const auto sign = (a.approximate() - b.approximate()).sign()) return order(*sign);
  const HitTime::Exact ta = a.exact(), tb = b.exact();
  return order(two_root_sign(ta.p * tb.a - tb.p * ta.a, ta.s, ta.q * tb.a * tb.a, -tb.s,
                             tb.q * ta.a * ta.a));
}

std::optional<SegmentHit> hit_segment(const Ray& ray, const Segment& segment) {
  using Place = SegmentHit::Place;
  const Sign a = side_of_ray(ray, segment.a), b = side_of_ray(ray, segment.b);
  if (a == b) {
    if (a != Sign::zero || segment.a != segment.b) return std::nullopt;
    const Vec2 across = std::fabs(ray.direction.x()) > 0 ? Vec2(0, 1) : Vec2(1, 0);
    return SegmentHit{Place::at_a, HitTime::on_line(ray, segment.a, Vec2(0, 0), across)};
  }
  if (a != Sign::zero && b != Sign::zero)
    return SegmentHit{Place::inner, HitTime::on_line(ray, segment)};
  return SegmentHit{a == Sign::zero ? Place::at_a : Place::at_b, HitTime::on_line(ray, segment)};
}

std::optional<CircleHit> hit_circle(const Ray& ray, const Circle& circle) {
  const Sign chord = decide(
      [&](const auto& number) { return circle_time(number, ray, circle.centre, circle.radius).q; });
  if (chord == Sign::negative) return std::nullopt;
  return CircleHit{chord == Sign::zero, HitTime::on_circle(ray, circle, HitTime::Root::first),
                   HitTime::on_circle(ray, circle, HitTime::Root::second)};
}

}  // namespace flatray
