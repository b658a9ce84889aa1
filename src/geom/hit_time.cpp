#include "geom/hit_time.h"

#include <limits>

#include "geom/decide.h"

namespace flatray {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();

// As in eq. 3 of the paper.
template <class Make>
auto line_time(const Make& number, const Ray& ray, const Vec2& p, const Vec2& from, const Vec2& to,
               const Vec2& velocity) {
  return Quotient<decltype(number(0.0))>{determinant(number, ray.origin, p, from, to),
                                         determinant(number, velocity, ray.direction, from, to)};
}

}  // namespace

HitTime HitTime::on_line(const Ray& ray, const Vec2& p, const Vec2& from, const Vec2& to,
                         const Vec2& velocity) {
  HitTime time;
  time.ray_ = ray;
  time.p_ = p;
  time.from_ = from;
  time.to_ = to;
  time.velocity_ = velocity;
  return time;
}

HitTime HitTime::on_curve(const Ray& ray, const Ellipse& curve, Root root, const Vec2& velocity) {
  HitTime time = on_line(ray, curve.centre, curve.u, curve.v, velocity);
  time.root_ = root_sign(root);
  return time;
}

struct HitTime::OnBezier {
  Bezier curve;
  BezierRoot root;
  Bounded time;
};

HitTime HitTime::on_curve(const Ray& ray, const Bezier& curve, const BezierRoot& root) {
  const auto at = [&](const auto& number, const auto& s) {
    const auto d = pair_of(number, ray.direction);
    return form_at(number, curve, ahead_of_ray(number, curve, ray), s) / dot(d, d);
  };
  Quick quick = 0;
  with_fused([&] { quick = at(kQuick, Quick(root.s.value(), root.s.error())); });
  const Bounded t =
      quick.is_rounded() ? Bounded(quick.value(), quick.error()) : at(kBounded, root.s);
  HitTime time;
  time.ray_ = ray;
  time.bezier_ = std::make_shared<const OnBezier>(OnBezier{curve, root, t});
  return time;
}

template <class Make>
auto HitTime::direction(const Make& number) const {
  const auto d = pair_of(number, ray_.direction);
  return velocity_ == Vec2(0, 0) ? d : d - pair_of(number, velocity_);
}
template <class Make>
auto HitTime::time_of_curve(const Make& number) const {
  return curve_time(number, ray_.origin, direction(number), curve());
}

Sign HitTime::sign() const { return sign_of(compare(0)); }

std::strong_ordering HitTime::compare(double other) const {
  if (std::isinf(other)) return 0 <=> (other > 0 ? 1 : -1);
  if (bezier_) {
    if (const auto sign = (bezier_->time - Bounded(other)).sign()) return order(*sign);
    const auto d = pair_of(kRational, ray_.direction), o = pair_of(kRational, ray_.origin);
    const Rational square = dot(d, d);
    const auto later = bernstein_of(kRational, bezier_->curve, [&](const Vec2& p) {
      return dot(d, pair_of(kRational, p) - o) - other * square;
    });
    return order(exact_parameter(bezier_->curve, ray_, bezier_->root).sign_of(powers_of(later)));
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
    return curve_power(
        number, curve(),
        pair_of(number, ray_.origin) + number(other) * direction(number) - pair_of(number, p_));
  });
  if (outside == Sign::negative) return order(static_cast<Sign>(root_));
  const Sign middle = decide([&](const auto& number) {
    const auto time = time_of_curve(number);
    return time.b - number(other) * time.a;
  });
  if (outside == Sign::zero && static_cast<int>(middle) != root_)
    return std::strong_ordering::equal;
  return order(middle);
}

template <class Make>
auto HitTime::in(const Make& number) const -> decltype(number(0.0)) {
  if (root_ != 0) return time_of_curve(number).root(root_);
  const auto time = line_time(number, ray_, p_, from_, to_, velocity_);
  return time.numer / time.denom;
}

Bounded HitTime::approximate() const { return bezier_ ? bezier_->time : in(kBounded); }

Quadratic HitTime::exact() const {
  if (root_ != 0) return root_of(time_of_curve(kRational), root_);
  const auto time = line_time(kRational, ray_, p_, from_, to_, velocity_);
  return time.numer / time.denom;
}

RealRoot HitTime::algebraic() const {
  if (bezier_) {
    const auto d = pair_of(kRational, ray_.direction);
    Bernstein<Rational> ahead = ahead_of_ray(kRational, bezier_->curve, ray_);
    const Rational square = dot(d, d);
    for (Rational& c : ahead) c /= square;
    return exact_form(bezier_->curve, ray_, bezier_->root, ahead);
  }
  const Quadratic time = exact();
  const Rational &middle = time.rational(), square = time.square_of_rest();
  if (square.sign() == Sign::zero) return RealRoot(middle);
  const Rational far = square + Rational(1);  // beyond the root of the square
  const Polynomial p{middle * middle - square, Rational(-2) * middle, 1};
  return RealRoot::all(p, root_ < 0 ? middle - far : middle, root_ < 0 ? middle : middle + far)[0];
}

RoundedTime HitTime::nearest() const {
  if (!bezier_) {
    std::optional<double> t;
    with_fused([&] { t = in(kQuick).nearest(); });
    if (t) return {*t, false};
  }
  const auto rounded = approximate().nearest();
  if (rounded && std::fabs(*rounded) < kLargest) return {*rounded, false};
  if (compare(kLargest) > 0) return {kLargest, true};
  if (compare(-kLargest) < 0) return {-kLargest, true};
  if (bezier_) return {algebraic().nearest(), false};
  return {exact().nearest(), false};
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

std::optional<SegmentHit> hit_segment(const Ray& ray, const Segment& segment) {
  using Part = SegmentHit::Part;
  const Sign a = side_of_ray(ray, segment.a), b = side_of_ray(ray, segment.b);
  if (a == b) {
    if (a != Sign::zero || segment.a != segment.b) return std::nullopt;
    const Vec2 across = std::fabs(ray.direction.x()) > 0 ? Vec2(0, 1) : Vec2(1, 0);
    return SegmentHit{Part::at_a, HitTime::on_line(ray, segment.a, Vec2(0, 0), across)};
  }
  const Part part = a == Sign::zero ? Part::at_a : b == Sign::zero ? Part::at_b : Part::inner;
  return SegmentHit{part, HitTime::on_line(ray, segment)};
}

std::optional<CurveHit> hit_curve(const Ray& ray, const Ellipse& curve, const Vec2& velocity) {
  const bool rests = velocity == Vec2(0, 0);
  const Sign chord = decide([&](const auto& number) {
    const auto d = pair_of(number, ray.direction);
    return curve_time(number, ray.origin, rests ? d : d - pair_of(number, velocity), curve).q;
  });
  if (chord == Sign::negative) return std::nullopt;
  return CurveHit{chord == Sign::zero, HitTime::on_curve(ray, curve, Root::first, velocity),
                  HitTime::on_curve(ray, curve, Root::second, velocity)};
}

std::optional<HitTime> hit_joint(const Ray& ray, const Ellipse& curve, const Vec2& end) {
  const Vec2& centre = curve.centre;
  // The ray's line meets that of the centre c and the end e in c + s (e - c), s = side / turn.
  const Sign turn = -turn_from_edge(centre, end, ray.direction);
  const Sign side = side_of_ray(ray, centre);
  // Its sides: of the centre w0, of the end w0 + turn; s = -w0 / turn.
  if (turn == Sign::zero ? side != Sign::zero : side * turn != Sign::negative) return std::nullopt;
  const Sign place = curve_side(end, curve);  // last: an end is so near that filters cannot tell
  if (place == Sign::zero) return std::nullopt;
  if (turn == Sign::zero) return HitTime::abreast(ray, end);
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
  if (power != place) return std::nullopt;
  return HitTime::on_line(ray, centre, centre, end);
}

}  // namespace flatray
