#include "oracle/exact.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "oracle/point.h"

namespace flatray::oracle {
namespace {

Point at(const Ray& ray, const Rational& t) { return exact(ray.origin) + t * exact(ray.direction); }
bool same(const Point& a, const Point& b) { return is_zero(a - b); }

bool between(const Rational& a, const Rational& x, const Rational& b) {
  return std::min(a, b) <= x && x <= std::max(a, b);
}

// Above (positive), on or below the line a-b at x; to its left where it is vertical and runs up.
Sign side(const Point& a, const Point& b, const Point& c) {
  const Rational run = b.x - a.x, ahead = c.x - a.x;
  if (run.sign() == Sign::zero) return a.y < b.y ? -ahead.sign() : ahead.sign();
  const Sign above = (c.y - a.y - (b.y - a.y) / run * ahead).sign();
  return run.sign() == Sign::positive ? above : -above;
}

bool holds(const Point& a, const Point& b, const Point& p) {
  if (!between(a.x, p.x, b.x) || !between(a.y, p.y, b.y)) return false;
  return same(a, b) || side(a, b, p) == Sign::zero;
}

StartPlace place(const Point& p, const std::vector<Point>& polygon) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if (holds(a, b, p)) return StartPlace::boundary;
    // Edges crossed by the half line from p to the right, each with its lower end and without its
    // upper.
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    if (p.x < a.x + (p.y - a.y) * (b.x - a.x) / (b.y - a.y)) inside = !inside;
  }
  return inside ? StartPlace::inside : StartPlace::outside;
}

// Where an edge meets the ray's line: none, one or (for an edge on the line) two parameters.
void meet(const Ray& ray, const Point& a, const Point& b, std::vector<Rational>& times) {
  const Point o = exact(ray.origin), d = exact(ray.direction), e = b - a, w = a - o;
  const Rational det = cross(d, e);
  if (det != 0) {
    const Rational along_edge = cross(w, d) / det;
    if (along_edge >= 0 && along_edge <= 1) times.push_back(cross(w, e) / det);
    return;
  }
  for (const Point& end : {a, b}) {
    const Rational t = d.x.sign() != Sign::zero ? (end.x - o.x) / d.x : (end.y - o.y) / d.y;
    if (same(at(ray, t), end)) times.push_back(t);
  }
}

// The lowest edge that has the point at `t` and is crossed to the side of `centre` (inward) or away
// from it; without area, to the left or to the right; where there is none, the lowest that has it.
int edge_at(const Ray& ray, const std::vector<Point>& polygon, const Rational& t, bool inward) {
  const Point here = at(ray, t), ahead = at(ray, t + 1);
  Point centre{0, 0};
  const Rational count = static_cast<double>(polygon.size());
  for (const Point& p : polygon) centre = centre + Rational(1) / count * p;
  int any = kNoEdge;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if (!holds(a, b, here)) continue;
    if (any == kNoEdge) any = static_cast<int>(i);
    if (same(a, b)) continue;
    const Sign middle = side(a, b, centre), way = side(a, b, ahead);
    const Sign wanted = middle == Sign::zero ? Sign::positive : middle;
    if (way == (inward ? wanted : -wanted)) return static_cast<int>(i);
  }
  return any;
}

Clip point_test(StartPlace start, Range within) {
  Clip clip;
  clip.start = start;
  if (start == StartPlace::outside) return clip;
  clip.kind = start == StartPlace::inside ? HitClass::through : HitClass::touch;
  if (std::isfinite(within.low)) clip.t_enter = within.low;
  if (std::isfinite(within.high)) clip.t_exit = within.high;
  return clip;
}

HitClass class_of_place(StartPlace middle, bool one_point) {
  if (middle == StartPlace::inside) return HitClass::through;
  return one_point ? HitClass::touch : HitClass::along;
}

// |o + t d - c|^2 - r^2
Rational power(const Ray& ray, const Circle& circle, const Rational& t) {
  const Point out = at(ray, t) - exact(circle.centre);
  return dot(out, out) - Rational(circle.radius) * circle.radius;
}

// The parameter of the point of the line nearest to the centre.
Rational foot(const Ray& ray, const Circle& circle) {
  const Point way = exact(ray.direction);
  return dot(exact(circle.centre) - exact(ray.origin), way) / dot(way, way);
}

}  // namespace

Sign side_of_line(const Vec2& a, const Vec2& b, const Vec2& c) {
  return a == b ? Sign::zero : side(exact(a), exact(b), exact(c));
}

Clip clip_polygon(const Ray& ray, std::span<const Vec2> vertices, Range within) {
  std::vector<Point> polygon;
  for (const Vec2& v : vertices) polygon.push_back(exact(v));
  const StartPlace start = place(exact(ray.origin), polygon);
  if (ray.direction == Vec2(0, 0)) return point_test(start, within);
  std::vector<Rational> times;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    meet(ray, polygon[i], polygon[(i + 1) % polygon.size()], times);
  Clip clip;
  clip.start = start;
  if (times.empty()) return clip;
  const auto [first, last] = std::minmax_element(times.begin(), times.end());
  const bool from_range = std::isfinite(within.low) && *first <= within.low;
  const bool to_range = std::isfinite(within.high) && *last >= within.high;
  const Rational enter = from_range ? within.low : *first, exit = to_range ? within.high : *last;
  if (enter > exit) return clip;
  clip.kind = class_of_place(place(at(ray, (enter + exit) / 2), polygon), enter == exit);
  if (!from_range) clip.edge_enter = edge_at(ray, polygon, enter, true);
  if (!to_range) clip.edge_exit = edge_at(ray, polygon, exit, false);
  clip.t_enter = enter;
  clip.t_exit = exit;
  return clip;
}

std::strong_ordering root_against(const Ray& ray, const Circle& circle, int root,
                                  const Rational& t) {
  const Sign outside = power(ray, circle, t).sign();
  const auto middle = foot(ray, circle) <=> t;
  if (outside == Sign::negative) return root <=> 0;
  const bool is_this_root = middle == 0 || (middle < 0) == (root > 0);
  if (outside == Sign::zero && is_this_root) return std::strong_ordering::equal;
  return middle;
}

HitClass verdict_on_disc(const Ray& ray, const Circle& circle) {
  const auto outside = power(ray, circle, foot(ray, circle)) <=> 0;
  return outside > 0 ? HitClass::miss : outside < 0 ? HitClass::through : HitClass::touch;
}

StartPlace place_in_disc(const Vec2& point, const Circle& circle) {
  const auto outside = power({point, {0, 0}}, circle, 0) <=> 0;
  return outside > 0   ? StartPlace::outside
         : outside < 0 ? StartPlace::inside
                       : StartPlace::boundary;
}

}  // namespace flatray::oracle
