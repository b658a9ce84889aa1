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

/// Puts the circles into competition with the best hit so far, whose t is `best.t`.
inline void offer_circles(const Surfaces& walls, const Start& ray, const Left& left,
                          NearestHit& best) {
  for (std::size_t i = 0; i < walls.circles.size(); ++i) {
    const Circle& circle = walls.circles[i];
    const std::uint32_t number = walls.circle_numbers[i];
    const float wx = ray.x - single(circle.centre.x()), wy = ray.y - single(circle.centre.y());
    const float r = single(circle.radius);
    const float a = ray.dx * ray.dx + ray.dy * ray.dy, b = wx * ray.dx + wy * ray.dy;
    const float root = std::sqrt(b * b - a * (wx * wx + wy * wy - r * r));
    for (const Root which : {Root::first, Root::second}) {
      const double t = static_cast<double>((which == Root::first ? -b - root : -b + root) / a);
      const bool stood_on =
          number == left.surface && (left.root == which || left.root == Root::both);
      if (stood_on || !(t >= 0 && t < best.t)) continue;
      best = {number, HitClass::through, which, false, t};
    }
  }
}

}  // namespace flatray::plain
