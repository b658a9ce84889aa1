#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "trace/hits.h"
#include "trace/rays.h"

// Textbook formulas in floats or doubles, without bounds: for the tracers that are not exact.
namespace flatray::plain {

inline constexpr float kNever = std::numeric_limits<float>::infinity();
inline float single(double x) { return static_cast<float>(x); }

template <class Number>
struct Start {
  Number x, y, dx, dy;
};
template <class Number>
Start<Number> start_of(const Ray& ray) {
  const auto number = [](double x) { return static_cast<Number>(x); };
  return {number(ray.origin.x()), number(ray.origin.y()), number(ray.direction.x()),
          number(ray.direction.y())};
}

/// A segment by an end and the way to the other.
struct Line {
  float x, y, ex, ey;
};
inline float time_of(const Start<float>& ray, const Line& edge) {
  const float wx = edge.x - ray.x, wy = edge.y - ray.y;
  const float across = ray.dx * edge.ey - ray.dy * edge.ex;
  const float t = (wx * edge.ey - wy * edge.ex) / across;
  const float place = (wx * ray.dy - wy * ray.dx) / across;
  if (t >= 0 && place >= 0 && place <= 1) return t;  // parallel: infinite or no number
  return kNever;
}

/// Whether a point, as seen from the centre of its curve, lies on the arc.
template <class Number>
bool is_on(const Arc& arc, const Pair<Number>& w) {
  const auto number = [](double x) { return static_cast<Number>(x); };
  return place_in_cone(arc, [&](const Vec2& p, const Vec2& a, const Vec2& b) {
           const Vec2 from = p - arc.curve.centre, way = b - a;
           return sign_of(static_cast<double>(number(way.x()) * (w.y - number(from.y())) -
                                              number(way.y()) * (w.x - number(from.x()))));
         }) != PlaceOn::outside;
}

/// Puts arc `number` into competition with the best hit so far, whose t is `best.t`.
template <class Number>
void offer(const Arc& arc, std::uint32_t number, const Ray& ray, const DepartedSurface& departed,
           NearestHit& best) {
  const auto number_of = [](double x) { return static_cast<Number>(x); };
  const auto d = pair_of(number_of, ray.direction);
  const auto w = pair_of(number_of, ray.origin) - pair_of(number_of, arc.curve.centre);
  const auto form_d = curve_form(number_of, arc.curve, d),
             form_w = curve_form(number_of, arc.curve, w);
  const Number size = form_size(number_of, arc.curve);
  const Number a = dot(form_d, form_d), b = dot(form_d, form_w);
  const Number root = std::sqrt(b * b - a * (dot(form_w, form_w) - size * size));
  for (const Root which : {Root::first, Root::second}) {
    const Number time = (which == Root::first ? -b - root : -b + root) / a;
    const double t = static_cast<double>(time);
    const bool stood_on =
        number == departed.surface && (departed.root == which || departed.root == Root::both);
    if (stood_on || !(t >= 0 && t < best.t) || !is_on(arc, w + time * d)) continue;
    best = {number, HitClass::through, which, false, t};
  }
}

/// Of a Bezier curve, by bisection between places where what is beside the ray changes its sign. What
/// the ray has left is the root nearest to its origin.
template <class Number>
void offer(const Bezier& wall, std::uint32_t number, const Ray& ray,
           const DepartedSurface& departed, NearestHit& best) {
  constexpr int kParts = 16, kHalvings = 50;
  const auto number_of = [](double x) { return static_cast<Number>(x); };
  const auto beside = beside_ray(number_of, wall, ray), ahead = ahead_of_ray(number_of, wall, ray);
  const auto d = pair_of(number_of, ray.direction);
  std::vector<NearestHit> met;
  for (int i = 0; i < kParts; ++i) {
    Number low = static_cast<Number>(i) / kParts, high = static_cast<Number>(i + 1) / kParts;
    const bool from = bernstein_value(beside, low) > 0, to = bernstein_value(beside, high) > 0;
    if (from == to) continue;
    for (int step = 0; step < kHalvings; ++step) {
      const Number middle = (low + high) / 2;
      ((bernstein_value(beside, middle) > 0) == from ? low : high) = middle;
    }
    const auto t = static_cast<double>(form_at(number_of, wall, ahead, high) / dot(d, d));
    met.push_back({number, HitClass::through, to ? Root::first : Root::second, false, t});
  }
  if (number == departed.surface && departed.root != Root::none && !met.empty())
    met.erase(std::min_element(met.begin(), met.end(), [](const auto& a, const auto& b) {
      return std::fabs(a.t) < std::fabs(b.t);
    }));
  for (const NearestHit& hit : met)
    if (hit.t >= 0 && hit.t < best.t) best = hit;
}

/// For who visits walls that may be straight.
template <class Number>
void offer(const Segment&, std::uint32_t, const Ray&, const DepartedSurface&, NearestHit&) {}

/// The same of curved wall `number`.
template <class Number>
void offer_curve(const Surfaces& walls, std::uint32_t number, const Ray& ray,
                 const DepartedSurface& departed, NearestHit& best) {
  walls.visit(number, [&](const auto& wall) { offer<Number>(wall, number, ray, departed, best); });
}

/// The same of all curved walls.
template <class Number>
void offer_curves(const Surfaces& walls, const Ray& ray, const DepartedSurface& departed,
                  NearestHit& best) {
  for (const std::uint32_t number : walls.curve_numbers)
    offer_curve<Number>(walls, number, ray, departed, best);
}

}  // namespace flatray::plain
