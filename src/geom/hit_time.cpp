#include "geom/hit_time.h"

#include <limits>
#include <type_traits>

#include "geom/decide.h"
#include "geom/quick.h"
#include "geom/quick_quotient.h"

namespace flatray {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();

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

// t = (b +- sqrt(q)) / a on a curve, in the form in which it is a circle.
template <class Number>
struct CurveTime {
  Number a, b, q;
  Number outside;  // of the origin: the product of the roots, times a
};
template <class Make, class Number = std::invoke_result_t<Make, double>>
CurveTime<Number> curve_time(const Make& number, const Ray& ray, const Ellipse& curve) {
  const auto d = curve_form(number, curve, pair_of(number, ray.direction));
  const auto w =
      curve_form(number, curve, pair_of(number, curve.centre) - pair_of(number, ray.origin));
  const auto size = form_size(number, curve);
  const auto r2 = size * size, a = dot(d, d), k = cross(d, w);
  return {a, dot(d, w), r2 * a - k * k, dot(w, w) - r2};
}

template <class Make, class Number = std::invoke_result_t<Make, double>>
Number root_time(const Make& number, const Ray& ray, const Ellipse& curve, int s) {
  const auto time = curve_time(number, ray, curve);
  const Number root = s > 0 ? square_root(time.q) : -square_root(time.q);
  // b and the root may cancel: then the other root and the product of both.
  if ((time.b.hi() > 0) == (s > 0)) return (time.b + root) / time.a;
  return time.outside / (time.b - root);
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

HitTime HitTime::on_curve(const Ray& ray, const Ellipse& curve, Root root) {
  HitTime time = on_line(ray, curve.centre, curve.u, curve.v);
  time.root_ = root_sign(root);
  return time;
}

struct HitTime::OnBezier {
  Bezier curve;
  BezierRoot root;
  Bounded time;
};

HitTime HitTime::on_curve(const Ray& ray, const Bezier& curve, const BezierRoot& root) {
  const auto d = pair_of(kBounded, ray.direction);
  const Bounded t = bernstein_value(ahead_of_ray(kBounded, curve, ray), root.s) / dot(d, d);
  HitTime time;
  time.ray_ = ray;
  time.bezier_ = std::make_shared<const OnBezier>(OnBezier{curve, root, t});
  return time;
}

Sign HitTime::sign() const { return sign_of(compare(0)); }

std::strong_ordering HitTime::compare(double other) const {
  if (std::isinf(other)) return 0 <=> (other > 0 ? 1 : -1);
  if (bezier_) {
    if (const auto sign = (bezier_->time - Bounded(other)).sign()) return order(*sign);
    const auto d = pair_of(kRational, ray_.direction);
    Polynomial ahead = powers_of(ahead_of_ray(kRational, bezier_->curve, ray_));
    ahead[0] -= other * dot(d, d);
    return order(exact_parameter(bezier_->curve, ray_, bezier_->root).sign_of(ahead));
  }
  if (root_ == 0) {
    const Sign denom = denominator();
    if (other == 0) return order(cross_sign(ray_.origin, p_, from_, to_) * denom);
    const auto ahead = [&](const auto& number) {
      const auto time = line_time(number, ray_, p_, from_, to_, velocity_);
      return time.numer - number(other) * time.denom;
    };
    return order(decide(ahead) * denom);
  }
  // Between the roots the point at `other` is inside the curve; outside, the mid-point of the
  // chord tells the side.
  const Sign outside = decide([&](const auto& number) {
    return curve_power(number, curve(),
                       pair_of(number, ray_.origin) +
                           number(other) * pair_of(number, ray_.direction) - pair_of(number, p_));
  });
  if (outside == Sign::negative) return order(static_cast<Sign>(root_));
  const Sign middle = decide([&](const auto& number) {
    const auto time = curve_time(number, ray_, curve());
    return time.b - number(other) * time.a;
  });
  if (outside == Sign::zero && static_cast<int>(middle) != root_)
    return std::strong_ordering::equal;
  return order(middle);
}

Bounded HitTime::approximate() const {
  if (bezier_) return bezier_->time;
  if (root_ != 0) return root_time(kBounded, ray_, curve(), root_);
  const auto time = line_time(kBounded, ray_, p_, from_, to_, velocity_);
  return time.numer / time.denom;
}

HitTime::Exact HitTime::exact() const {
  if (root_ == 0) {
    auto time = line_time(kRational, ray_, p_, from_, to_, velocity_);
    if (time.denom.sign() == Sign::negative) return {-time.numer, 0, 0, -time.denom};
    return {std::move(time.numer), 0, 0, std::move(time.denom)};
  }
  auto time = curve_time(kRational, ray_, curve());
  const int s = time.q.sign() == Sign::zero ? 0 : root_;
  return {std::move(time.b), s, std::move(time.q), std::move(time.a)};
}

RealRoot HitTime::algebraic() const {
  if (bezier_) {
    const auto d = pair_of(kRational, ray_.direction);
    Polynomial ahead = powers_of(ahead_of_ray(kRational, bezier_->curve, ray_));
    const Rational square = dot(d, d);
    for (Rational& c : ahead) c /= square;
    return exact_parameter(bezier_->curve, ray_, bezier_->root).value_of(ahead);
  }
  const Exact time = exact();
  const Rational middle = time.p / time.a, square = time.q / (time.a * time.a);
  if (time.s == 0) return RealRoot(middle);
  const Rational far = square + Rational(1);  // beyond the root of the square
  const Polynomial p{middle * middle - square, Rational(-2) * middle, 1};
  return RealRoot::all(p, time.s < 0 ? middle - far : middle,
                       time.s < 0 ? middle : middle + far)[0];
}

RoundedTime HitTime::nearest() const {
  if (root_ == 0 && !bezier_) {
    const double t = quick_quotient(ray_.origin, p_, velocity_, ray_.direction, from_, to_);
    if (!std::isnan(t)) return {t, false};
  } else if (root_ != 0) {
    std::optional<double> t;
    with_fused([&] { t = root_time(kQuick, ray_, curve(), root_).nearest(); });
    if (t) return {*t, false};
  }
  const auto rounded = approximate().nearest();
  if (rounded && std::fabs(*rounded) < kLargest) return {*rounded, false};
  if (compare(kLargest) > 0) return {kLargest, true};
  if (compare(-kLargest) < 0) return {-kLargest, true};
  if (bezier_) return {algebraic().nearest(), false};
  const Exact time = exact();
  return {Rational::root_sum(time.p / time.a, time.s, time.q / (time.a * time.a)), false};
}

Sign HitTime::denominator() const { return cross_sign(velocity_, ray_.direction, from_, to_); }

// Of two lines without a division: times that are equal are then known to be where no digit is lost.
std::strong_ordering compare(const HitTime& a, const HitTime& b) {
  const bool by_polynomials = a.bezier_ || b.bezier_;
  if (a.root_ == 0 && b.root_ == 0 && !by_polynomials) {
    const auto time = [](const auto& number, const HitTime& of) {
      return line_time(number, of.ray_, of.p_, of.from_, of.to_, of.velocity_);
    };
    const Sign difference = decide([&](const auto& number) {
      const auto first = time(number, a), second = time(number, b);
      return first.numer * second.denom - second.numer * first.denom;
    });
    return order(difference * a.denominator() * b.denominator());
  }
  if (const auto sign = (a.approximate() - b.approximate()).sign()) return order(*sign);
  if (by_polynomials) return compare(a.algebraic(), b.algebraic());
  return compare(a.exact(), b.exact());
}

std::strong_ordering compare(const HitTime::Exact& a, const HitTime::Exact& b) {
  return order(
      Rational::two_root_sign(a.p * b.a - b.p * a.a, a.s, a.q * b.a * b.a, -b.s, b.q * a.a * a.a));
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

std::optional<CurveHit> hit_curve(const Ray& ray, const Ellipse& curve) {
  const Sign chord = decide([&](const auto& number) { return curve_time(number, ray, curve).q; });
  if (chord == Sign::negative) return std::nullopt;
  return CurveHit{chord == Sign::zero, HitTime::on_curve(ray, curve, Root::first),
                  HitTime::on_curve(ray, curve, Root::second)};
}

std::optional<HitTime> hit_joint(const Ray& ray, const Ellipse& curve, const Vec2& end) {
  const Vec2& centre = curve.centre;
  const Sign place = curve_side(end, curve);
  if (place == Sign::zero) return std::nullopt;
  // The ray's line meets that of the centre c and the end e in c + s (e - c), s = side / turn.
  const Sign turn = -turn_from_edge(centre, end, ray.direction);
  const Sign side = side_of_ray(ray, centre);
  if (turn == Sign::zero) {
    if (side != Sign::zero) return std::nullopt;
    return HitTime::abreast(ray, end);
  }
  // Its sides: of the centre w0, of the end w0 + turn; s = -w0 / turn.
  if (side * turn != Sign::negative) return std::nullopt;
  const Sign beyond_end = -side_of_ray(ray, end) * turn;  // sign of s - 1
  if (beyond_end == place) return std::nullopt;
  const Sign power = decide([&](const auto& number) {
    const auto e = pair_of(number, end) - pair_of(number, centre);
    const auto d = pair_of(number, ray.direction);
    const auto s = cross(d, pair_of(number, ray.origin) - pair_of(number, centre));
    const auto form = curve_form(number, curve, e);
    const auto size = form_size(number, curve) * cross(d, e);
    return s * s * dot(form, form) - size * size;
  });
  if (power == -place) return std::nullopt;
  return HitTime::on_line(ray, centre, centre, end);
}

}  // namespace flatray
