#include "geom/exact_hit.h"

#include "geom/decide.h"
#include "geom/primitives/wall.h"

namespace flatray {

ExactHit::ExactHit(const Ray& ray, const Segment& wall, Root)
    : ray_(ray),
      time_(HitTime::on_line(ray, wall)),
      form_{0, 0},
      from_(line_point(kBounded, ray, wall)) {}

ExactHit::ExactHit(const Ray& ray, const Ellipse& wall, Root root)
    : ray_(ray), time_(HitTime::on_curve(ray, wall, root)), curve_(wall), form_{0, 0}, from_{0, 0} {
  const auto point = curve_point(kBounded, ray, wall, root_sign(root));
  form_ = point.form;
  from_ = point.from_centre;
}

ExactHit::ExactHit(const Ray& ray, const Bezier& wall, Root root)
    : ray_(ray), form_{0, 0}, from_{0, 0}, bezier_(wall) {
  const BezierRoot met = root_of(wall, ray, root);
  root_ = met;
  time_ = HitTime::on_curve(ray, wall, met);
  from_ = point_at(kBounded, wall, met.s);
  form_ = rate_at(kBounded, wall, met.s);
}

double ExactHit::rounded(const Polynomial& of_time) const {
  return bezier_ ? time_.algebraic().value_of(of_time).nearest()
                 : value_at(of_time, time_.exact()).nearest();
}

Vec2 ExactHit::nearest() const {
  const auto coordinate = [&](int axis, const Bounded& from) {
    if (const auto value = (Bounded(curve_.centre[axis]) + from).nearest()) return *value;
    constexpr double largest = std::numeric_limits<double>::max();
    return std::clamp(rounded({ray_.origin[axis], ray_.direction[axis]}), -largest, largest);
  };
  return {coordinate(0, from_.x), coordinate(1, from_.y)};
}

Vec2 ExactHit::normal() const {
  if (bezier_) {
    const auto rate = [&](int axis, const Bounded& near) {
      if (const auto value = near.nearest()) return *value;
      return exact_parameter(*bezier_, ray_, *root_)
          .value_of(powers_of(rates_of(kRational, *bezier_, axis)))
          .nearest();
    };
    return {-rate(1, form_.y), rate(0, form_.x)};
  }
  const auto near = sized_normal(kBounded, curve_, form_);
  const auto x = near.x.nearest(), y = near.y.nearest();
  if (x && y) return {*x, *y};
  const auto normal_of = [&](const Pair<Rational>& w) {
    return sized_normal(kRational, curve_, curve_form(kRational, curve_, w));
  };
  const auto at_origin =
      normal_of(pair_of(kRational, ray_.origin) - pair_of(kRational, curve_.centre));
  const auto rate = normal_of(pair_of(kRational, ray_.direction));
  return {rounded({at_origin.x, rate.x}), rounded({at_origin.y, rate.y})};
}

Sign ExactHit::sign(const Polynomial& of_time) const {
  return bezier_ ? time_.algebraic().sign_of(of_time) : value_at(of_time, time_.exact()).sign();
}

Sign ExactHit::turn(const Vec2& p, const Vec2& a, const Vec2& b) const {
  const auto edge = pair_of(kBounded, b) - pair_of(kBounded, a);
  const auto to_centre = pair_of(kBounded, curve_.centre) - pair_of(kBounded, p);
  if (const auto sign = cross(edge, to_centre + from_).sign()) return *sign;
  return this->sign({determinant(kRational, a, b, p, ray_.origin),
                     determinant(kRational, a, b, Vec2(0, 0), ray_.direction)});
}

Sign ExactHit::side_of(const Arc& wall) const {
  const Ellipse& curve = wall.curve;
  const auto to_centre = pair_of(kBounded, curve_.centre) - pair_of(kBounded, curve.centre);
  if (const auto sign = curve_power(kBounded, curve, to_centre + from_).sign()) return *sign;
  const auto w = curve_form(kRational, curve,
                            pair_of(kRational, ray_.origin) - pair_of(kRational, curve.centre));
  const auto d = curve_form(kRational, curve, pair_of(kRational, ray_.direction));
  const Rational size = form_size(kRational, curve);
  return this->sign({dot(w, w) - size * size, Rational(2) * dot(w, d), dot(d, d)});
}

// By what the ray meets of the wall next before or after it, or beside the wall's tangent.
Sign ExactHit::side_of(const Bezier& wall) const {
  if (place_on(wall) != PlaceOn::outside) return Sign::zero;
  const Bounded s = parameter_near(wall, nearest());
  const auto beside = pair_of(kBounded, curve_.centre) + from_ - point_at(kBounded, wall, s);
  if (const auto sign = cross(rate_at(kBounded, wall, s), beside).sign()) return *sign;
  std::vector<WallMeeting> met;
  meet(wall, ray_, {Root::none, false, true}, met);
  const double here = time_.nearest().t;
  Sign side = Sign::zero;
  double least = kInfinity;
  for (const WallMeeting& one : met)
    if (const double away = std::fabs(one.time.nearest().t - here); away < least) {
      least = away;
      side = enters(one.root) == (compare(one.time, time_) > 0) ? Sign::positive : Sign::negative;
    }
  return side;
}

PlaceOn ExactHit::place_on(const Bezier& wall) const {
  std::vector<WallMeeting> met;
  meet(wall, ray_, {Root::none, true, true}, met);
  for (const WallMeeting& one : met)
    if (compare(one.time, time_) == 0) return one.at_end ? PlaceOn::at_end : PlaceOn::inner;
  return PlaceOn::outside;
}

std::optional<Sign> ExactHit::touched_side(const Arc& arc) const {
  const Sign chord =
      decide([&](const auto& number) { return curve_time(number, ray_, arc.curve).q; });
  return chord == Sign::zero ? std::optional(Sign::positive) : std::nullopt;
}

// The curve bends away from it.
std::optional<Sign> ExactHit::touched_side(const Bezier& wall) const {
  std::vector<WallMeeting> met;
  meet(wall, ray_, {Root::none, true, true}, met);
  const auto here = std::ranges::find_if(
      met, [&](const WallMeeting& one) { return compare(one.time, time_) == 0; });
  if (here == met.end() || here->root != Root::both || here->at_end) return std::nullopt;
  return bend_at(wall, parameter_near(wall, nearest())) > 0 ? Sign::negative : Sign::positive;
}

}  // namespace flatray
