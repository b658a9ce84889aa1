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

}  // namespace

Sign side_of_line(const Vec2& a, const Vec2& b, const Vec2& c) {
  return a == b ? Sign::zero : side(exact(a), exact(b), exact(c));
}

Clip clip_polygon(const Ray& ray, std::span<const Vec2> vertices, Range within) {
  Clip clip{contact_truth({{&ray.origin, 1}, ray.direction}, {vertices, {0, 0}}, within)};
  if (clip.kind == HitClass::miss || ray.direction == Vec2(0, 0)) return clip;
  const std::vector<Point> polygon = exact_ring(vertices);
  // At an end of the range there is none.
  const auto edge = [&](const Rational& t, double end, bool inward) {
    return std::isfinite(end) && t == end ? kNoEdge : edge_at(ray, polygon, t, inward);
  };
  clip.edge_enter = edge(*clip.first, within.low, true);
  clip.edge_exit = edge(*clip.last, within.high, false);
  return clip;
}

}  // namespace flatray::oracle
