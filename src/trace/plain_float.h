#pragma once
#include <cmath>
#include <vector>

#include "trace/hits.h"
#include "trace/rays.h"

// Textbook formulas in single precision, without bounds: for the tracers that are not exact.
namespace flatray::plain {

inline constexpr float kNever = __builtin_inff();
inline float single(double x) { return static_cast<float>(x); }

struct Start {
  float x, y, dx, dy;
};
inline Start start_of(const Ray& ray) {
  return {single(ray.origin.x()), single(ray.origin.y()), single(ray.direction.x()),
          single(ray.direction.y())};
}

/// A segment by an end and the way to the other.
struct Edge {
  float x, y, ex, ey;
};
inline float time_of(const Start& ray, const Edge& edge) {
  const float wx = edge.x - ray.x, wy = edge.y - ray.y;
  const float across = ray.dx * edge.ey - ray.dy * edge.ex;
  const float t = (wx * edge.ey - wy * edge.ex) / across;
  const float place = (wx * ray.dy - wy * ray.dx) / across;
  return t >= 0 && place >= 0 && place <= 1 ? t : kNever;  // parallel: infinite or no number
}

/// Whether a point, as seen from the centre of its curve, lies on the arc.
inline bool is_on(const Arc& arc, const Pair<float>& w) {
  return place_in_cone(arc, [&](const Vec2& p, const Vec2& a, const Vec2& b) {
           const Vec2 from = p - arc.curve.centre, way = b - a;
           return sign_of(static_cast<double>(single(way.x()) * (w.y - single(from.y())) -
                                              single(way.y()) * (w.x - single(from.x()))));
         }) != ArcPlace::outside;
}

/// Puts the curved walls into competition with the best hit so far, whose t is `best.t`.
inline void offer_curves(const Surfaces& walls, const Ray& ray, const Left& left,
                         NearestHit& best) {
  if (!walls.any_curves()) return;
  for (std::uint32_t number = 0; number < walls.size(); ++number) {
    if (walls.is_straight(number)) continue;
    const Arc arc = walls.arc(number);
    const auto d = pair_of(single, ray.direction);
    const auto w = pair_of(single, ray.origin) - pair_of(single, arc.curve.centre);
    const auto form_d = curve_form(single, arc.curve, d), form_w = curve_form(single, arc.curve, w);
    const float size = form_size(single, arc.curve);
    const float a = dot(form_d, form_d), b = dot(form_d, form_w);
    const float root = std::sqrt(b * b - a * (dot(form_w, form_w) - size * size));
    for (const Root which : {Root::first, Root::second}) {
      const float time = (which == Root::first ? -b - root : -b + root) / a;
      const double t = static_cast<double>(time);
      const bool stood_on =
          number == left.surface && (left.root == which || left.root == Root::both);
      if (stood_on || !(t >= 0 && t < best.t) || !is_on(arc, w + time * d)) continue;
      best = {number, HitClass::through, which, false, t};
    }
  }
}

}  // namespace flatray::plain
