#include "geom/quick_hit.h"

#include "geom/decide.h"
#include "geom/primitives/wall.h"

namespace flatray {
namespace {

// Beyond these, steps of some ulps times sizes would underflow, or sizes overflow.
constexpr double kLeast = 0x1p-450, kMost = 0x1p450;

bool is_sound(const Quick& x, const Quick& y) {
  const double size = std::max(x.size(), y.size());
  return size > kLeast && size < kMost;
}

void place(QuickHit& hit, const Quick& x, const Quick& y) {
  hit.nearest = Vec2(x.hi() + 0.0, y.hi() + 0.0);  // never -0
  hit.rest = {Near::within(x.lo(), x.error()), Near::within(y.lo(), y.error())};
  hit.is_certain = x.is_rounded() && y.is_rounded();
}

Pair<Near> step_from(const QuickHit& hit, const Vec2& point) {
  return pair_of(kNear, Vec2(point - hit.nearest)) - hit.rest;  // exact but for the rest
}

}  // namespace

QuickHit quick_hit(const Ray& ray, const Segment& wall, Root) {
  QuickHit hit;
  with_fused([&] {
    const auto point = line_point(kQuick, ray, wall);
    place(hit, point.x, point.y);
  });
  hit.normal = normal_near(wall, hit.nearest);
  hit.is_normal_certain = true;
  return hit;
}

QuickHit quick_hit(const Ray& ray, const Arc& wall, Root root) {
  const Ellipse& curve = wall.curve;
  QuickHit hit;
  with_fused([&] {
    const auto point = curve_point(kQuick, ray, curve, root_sign(root));
    const auto normal = sized_normal(kQuick, curve, point.form);
    place(hit, point.from_centre.x + curve.centre.x(), point.from_centre.y + curve.centre.y());
    hit.form = {near_of(point.form.x), near_of(point.form.y)};
    hit.is_certain = hit.is_certain && is_sound(point.form.x, point.form.y);
    hit.normal = Vec2(normal.x.hi(), normal.y.hi());
    hit.is_normal_certain = normal.x.is_rounded() && normal.y.is_rounded();
  });
  return hit;
}

// On upright and level walls one difference tells all.
[[gnu::flatten]] std::optional<Sign> side_by_hit(const Segment& wall, const QuickHit& hit,
                                                 const Vec2& point) {
  const Vec2 &a = wall.a, &b = wall.b;
  if (a.x() == b.x()) return sign_of(b.y() - a.y()) * sign_of(a.x() - point.x());
  if (a.y() == b.y()) return sign_of(b.x() - a.x()) * sign_of(point.y() - a.y());
  return cross(pair_of(kNear, b) - pair_of(kNear, a), step_from(hit, point)).sign();
}

// |f(w + s)|^2 - |f(w)|^2 with the form f, w the exact point seen from the centre and s the step.
[[gnu::flatten]] std::optional<Sign> side_by_hit(const Arc& wall, const QuickHit& hit,
                                                 const Vec2& point) {
  const auto step = curve_form(kNear, wall.curve, step_from(hit, point));
  return dot(hit.form + hit.form + step, step).sign();
}

}  // namespace flatray
