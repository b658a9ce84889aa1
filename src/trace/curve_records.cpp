#include "trace/curve_records.h"

#include <algorithm>
#include <cmath>

#include "geom/decide.h"

namespace flatray {
namespace {

// A vector in the form in which the curve is a circle.
Vec2 form_of(const Ellipse& curve, const Vec2& w) {
  const Pair<double> form = curve_form(kPlain, curve, Pair<double>{w.x(), w.y()});
  return {form.x, form.y};
}
// How far forms in a box about w may be from that of w.
double spread_of(const Ellipse& curve, const Vec2& w, const Vec2& half) {
  if (curve.is_circle()) return half.norm();
  const Vec2 u = curve.u.cwiseAbs(), v = curve.v.cwiseAbs(), far = w.cwiseAbs();
  const Vec2 spread(half.x() * v.y() + half.y() * v.x(), u.x() * half.y() + u.y() * half.x());
  const double terms = far.x() * v.y() + far.y() * v.x() + u.x() * far.y() + u.y() * far.x();
  return spread.norm() + 0x1p-48 * terms;
}

// Of a disc's centre c of size M, as seen from the origin o, d x (c - o) and d . (c - o) are off by less than 5 u
// |d| (M + |o|), u = 2^-53; the centre itself by u M, its radius by some u of itself, a product for t by 8 u of the
// same: 16 u are allowed for.
double slack_beside(double speed, double size) {
  const auto is_sound = [](double x) { return x > 0x1p-400 && x < 0x1p400; };
  return is_sound(size) && is_sound(speed) ? 0x1p-49 * speed * size : kInfinity;
}

// Sizes of forms, which are products of two coordinates and squared.
bool is_sound_form(double size) { return size > 0x1p-200 && size < 0x1p200; }

}  // namespace

// Of flat curves the form loses digits.
bool ends_on_curve(const Arc& wall) {
  if (wall.extent != Arc::Extent::between) return true;
  const auto [least, most] = half_axes(wall.curve);
  if (!(std::fabs(least) > 0x1p-10 * most &&
        is_sound_form(std::fabs(form_size(kPlain, wall.curve)))))
    return false;
  const auto near = [&](const Vec2& end) {
    const double length = form_of(wall.curve, end - wall.curve.centre).norm();
    const double r = std::fabs(form_size(kPlain, wall.curve));
    return std::fabs(length - r) < 0x1p-40 * r;
  };
  return near(wall.from) && near(wall.to);
}

// In the form in which its curve is a circle the part of a half turn and less lies in the disc whose
// diameter is its chord.
BoundingDisc disc_about(const Arc& wall) {
  const double axis = half_axes(wall.curve).most;
  const Vec2& centre = wall.curve.centre;
  if (wall.extent != Arc::Extent::between) return {centre, axis};
  if (ends_on_curve(wall) && orientation(centre, wall.from, wall.to) == Sign::positive) {
    const double half = 0.5 * form_of(wall.curve, wall.to - wall.from).norm();
    const double size = std::fabs(form_size(kPlain, wall.curve));
    // Ends that rounding moved may have changed their order, where they are close together.
    if (half > 0x1p-13 * size)
      return {0.5 * wall.from + 0.5 * wall.to, axis * (half / size + 0x1p-38)};
  }
  return {centre, std::max({axis, (wall.from - centre).norm(), (wall.to - centre).norm()})};
}

DiscFilter::DiscFilter(const Ray& ray, double magnitude)
    : origin_(ray.origin),
      direction_(ray.direction),
      speed_((1 + 0x1p-47) * direction_.norm()),
      slack_(slack_beside(speed_, magnitude + origin_.cwiseAbs().sum())),
      per_square_(1 / direction_.squaredNorm()) {}

ArcForm::ArcForm(const Arc& wall) : size(std::fabs(form_size(kPlain, wall.curve))) {
  const Ellipse& curve = wall.curve;
  if (wall.extent == Arc::Extent::whole || !ends_on_curve(wall)) return;
  const double turn = std::copysign(1, form_size(kPlain, curve));
  if (wall.extent == Arc::Extent::half) {
    const Vec2 towards = wall.from / wall.from.cwiseAbs().maxCoeff();  // whose squares are normal
    middle = turn * Vec2(curve.u.dot(towards), curve.v.dot(towards)).stableNormalized();
    cut = 0;
    return;
  }
  const Vec2 from = form_of(curve, wall.from - curve.centre).normalized();
  const Vec2 chord = form_of(curve, wall.to - curve.centre).normalized() - from;
  if (!(chord.norm() > 0x1p-12)) return;
  middle = turn * Vec2(chord.y(), -chord.x()).normalized();
  cut = middle.dot(from);
}

ArcPasses::ArcPasses(const Arc& wall, const Vec2& low)
    : wall_(wall),
      form_(wall),
      box_(bounds_of(wall)),
      low_(low),
      is_sound_(is_sound_form(form_.size) && ends_on_curve(wall)) {}

bool ArcPasses::operator()(const Vec2& middle, const Vec2& half) const {
  constexpr double kOff = 0x1p-30;
  const Vec2 below = box_.low - low_ - middle, above = box_.high - low_ - middle;
  if (below.x() > half.x() || below.y() > half.y() || above.x() < -half.x() ||
      above.y() < -half.y())
    return false;
  if (!is_sound_) return true;
  const Vec2 at = low_ - wall_.curve.centre + middle, form = form_of(wall_.curve, at);
  const double length = form.norm(), most = spread_of(wall_.curve, at, half), r = form_.size;
  if (!is_sound_form(length + most)) return true;
  const bool is_beside_part = form.dot(form_.middle) + most < r * (form_.cut - kOff);
  return length - most <= r * (1 + kOff) && length + most >= r * (1 - kOff) && !is_beside_part;
}

lanes::Curve curve_form_in_lanes(const Arc& wall, double reach) {
  const auto& [centre, u, v] = wall.curve;
  const double size = u.x() * v.y() - u.y() * v.x(), difference = u.squaredNorm() - v.squaredNorm();
  const double most =
      std::sqrt(0.5 * (u.squaredNorm() + v.squaredNorm() + Vec2(difference, 2 * u.dot(v)).norm()));
  const double least = std::fabs(size) / most;
  const bool is_round = least > 0x1p-6 * most && least > 0x1p-40 && most <= reach;
  if (!(is_round && centre.cwiseAbs().maxCoeff() <= reach && ends_on_curve(wall)))
    return doubtful_curve();
  const ArcForm part(wall);
  if (wall.extent != Arc::Extent::whole && part.cut == -4) return doubtful_curve();
  const double radius = least * (1 - 0x1p-20), scale = radius / size;
  // Here the form is divided by `size`, whose sign it takes.
  const Vec2 middle = std::copysign(1, size) * part.middle;
  const auto single = [](double x) { return static_cast<float>(x); };
  return {
      single(centre.x()),    single(centre.y()),     single(radius),         0,
      single(scale * v.y()), single(-scale * v.x()), single(-scale * u.y()), single(scale * u.x()),
      single(middle.x()),    single(middle.y()),     single(part.cut),       0};
}

}  // namespace flatray
