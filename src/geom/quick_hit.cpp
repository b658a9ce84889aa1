#include "geom/quick_hit.h"

#include <algorithm>
#include <limits>

#include "geom/decide.h"

namespace flatray {
namespace {

constexpr double kGradientScale = 0x1p500, kLeastStep = 0x1p-1000;
// Beyond these a gradient, or its product with a step, might not be sound.
constexpr double kMost = 0x1p300, kLeast = 0x1p-300;

Pair<Quick> way(const Vec2& from, const Vec2& to) {
  return {Quick::difference(to.x(), from.x()), Quick::difference(to.y(), from.y())};
}

void place(QuickHit& hit, const Quick& x, const Quick& y) {
  hit.nearest = Vec2(x.hi(), y.hi());  // never -0
  hit.rest = Vec2(x.lo(), y.lo());
  hit.error = Vec2(x.error(), y.error());
}

bool is_sound(const Vec2& gradient) {
  const double size = std::max(std::fabs(gradient.x()), std::fabs(gradient.y()));
  return size > kLeast && size < kMost;
}

void hit_line(const Ray& ray, const Segment& wall, QuickHit& hit) {
  const Pair<Quick> edge = way(wall.a, wall.b), start = way(ray.origin, wall.a);
  const Vec2& d = ray.direction;
  const Quick t = cross(start, edge) / (edge.y * d.x() - edge.x * d.y());
  const bool upright = wall.a.x() == wall.b.x(), level = wall.a.y() == wall.b.y();
  const Quick x = upright ? Quick(wall.a.x() + 0.0) : t * d.x() + Quick(ray.origin.x());
  const Quick y = level ? Quick(wall.a.y() + 0.0) : t * d.y() + Quick(ray.origin.y());
  place(hit, x, y);
  hit.normal = Vec2(-(wall.b.y() - wall.a.y()), wall.b.x() - wall.a.x());
  hit.is_normal_certain = true;
  hit.gradient = Vec2(-edge.y.hi(), edge.x.hi());
  hit.is_certain = (upright || x.is_rounded()) && (level || y.is_rounded()) &&
                   is_sound(hit.gradient) && hit.nearest.cwiseAbs().maxCoeff() < kMost;
  hit.gradient *= kGradientScale;
  hit.least = upright || level ? 0 : kLeastStep;
}

// See ExactHit for the formula.
void hit_curve(const Ray& ray, const Ellipse& wall, int s, QuickHit& hit) {
  const auto d = curve_form(kQuick, wall, pair_of(kQuick, ray.direction));
  const auto w = curve_form(kQuick, wall, way(wall.centre, ray.origin));
  const Quick r = form_size(kQuick, wall), size = dot(d, d), k = cross(d, w);
  const Quick along = square_root(r * r * size - k * k) * s;
  const Pair<Quick> form{(d.x * along - k * d.y) / size, (d.y * along + k * d.x) / size};
  const Pair<Quick> from = curve_vector(kQuick, wall, form),
                    normal = sized_normal(kQuick, wall, form);
  hit.bend = wall.is_circle() ? 1 : (wall.u.squaredNorm() + wall.v.squaredNorm()) / r.size();
  const Quick x = from.x + wall.centre.x(), y = from.y + wall.centre.y();
  place(hit, x, y);
  hit.normal = Vec2(normal.x.hi(), normal.y.hi());
  hit.gradient = r.hi() < 0 ? Vec2(-hit.normal) : hit.normal;
  hit.is_certain = x.is_rounded() && y.is_rounded() && is_sound(hit.gradient) &&
                   hit.nearest.cwiseAbs().maxCoeff() < kMost;
  hit.is_normal_certain = normal.x.is_rounded() && normal.y.is_rounded();
  hit.gradient *= kGradientScale;
  hit.gradient_error =
      kGradientScale * 2 *
      (normal.x.error() + normal.y.error() + 0x1p-52 * (normal.x.size() + normal.y.size()));
  hit.bend *= kGradientScale;
  hit.least = kLeastStep;
}

// 2 (d.e) e / e.e - d
Vec2 mirrored(const Vec2& d, const Vec2& e) {
  const Quick dot = Quick::product(d.x(), e.x()) + Quick::product(d.y(), e.y());
  const Quick size = Quick::product(e.x(), e.x()) + Quick::product(e.y(), e.y());
  const Quick twice = dot / size * 2;
  const Quick x = twice * e.x() - Quick(d.x()), y = twice * e.y() - Quick(d.y());
  constexpr double kDoubt = std::numeric_limits<double>::quiet_NaN();
  if (!x.is_rounded() || !y.is_rounded()) return {kDoubt, kDoubt};
  return {x.hi(), y.hi()};
}

}  // namespace

QuickHit quick_hit(const Ray& ray, const Segment& wall, Root) {
  QuickHit hit;
  with_fused([&] { hit_line(ray, wall, hit); });
  return hit;
}

QuickHit quick_hit(const Ray& ray, const Ellipse& wall, Root root) {
  QuickHit hit;
  with_fused([&] { hit_curve(ray, wall, root_sign(root), hit); });
  return hit;
}

Vec2 quick_reflection(const Vec2& direction, const Vec2& along) {
  Vec2 out;
  with_fused([&] { out = mirrored(direction, along); });
  return out;
}

}  // namespace flatray
