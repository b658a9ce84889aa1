#include "render/gl/outlines.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "base/portable_math.h"
#include "render/gl/grid.h"

namespace flatray::gl {
namespace {

Vec2 on_circle(const Vec2& centre, double radius, double angle) {
  return centre + radius * Vec2(portable::cos(angle), portable::sin(angle));
}

// Points of an arc after its first.
void add_arc(const Vec2& centre, double radius, double from, double to, const Bounds& box,
             Ring& ring) {
  const Vec2 begin = ring.back(), end = on_circle(centre, radius, to);
  const double sagitta = radius * (1 - portable::cos(0.5 * (to - from)));
  Bounds reach;
  reach.add(begin), reach.add(end);
  const Vec2 margin(sagitta, sagitta);
  if (sagitta * kGridSteps <= 1 || !box.meets({reach.low - margin, reach.high + margin})) {
    ring.push_back(end);
    return;
  }
  const double middle = 0.5 * (from + to);
  if (middle <= from || middle >= to) return;
  add_arc(centre, radius, from, middle, box, ring);
  add_arc(centre, radius, middle, to, box, ring);
}

// Keeps the side of a line where coordinate `axis`, times `sign`, is at least `limit` times `sign`.
Ring kept_side(const Ring& ring, int axis, double sign, double limit) {
  Ring kept;
  const auto inside = [&](const Vec2& p) { return sign * (p[axis] - limit) >= 0; };
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    if (inside(a)) kept.push_back(a);
    if (inside(a) == inside(b)) continue;
    const double share = (limit - a[axis]) / (b[axis] - a[axis]);
    Vec2 crossing = a + share * (b - a);
    crossing[axis] = limit;
    kept.push_back(crossing);
  }
  return kept;
}

}  // namespace

Ring circle_ring(const Vec2& centre, double radius, const Bounds& box) {
  constexpr int kArcs = 8;
  Ring ring = {on_circle(centre, radius, 0)};
  for (int i = 0; i < kArcs; ++i)
    add_arc(centre, radius, 2 * std::numbers::pi * i / kArcs,
            2 * std::numbers::pi * (i + 1) / kArcs, box, ring);
  ring.pop_back();  // the first again
  return ring;
}

Ring clipped(Ring ring, const Bounds& box) {
  for (const int axis : {0, 1}) {
    ring = kept_side(ring, axis, 1, box.low[axis]);
    ring = kept_side(ring, axis, -1, box.high[axis]);
  }
  return ring;
}

// An edge is cut where it crosses a side of the box; between the cuts it is a straight line after
// clamping, too.
Ring clamped(const Ring& ring, const Bounds& box) {
  Ring moved;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    std::array<double, 5> cuts = {0, 1, 1, 1, 1};
    std::size_t count = 1;
    for (const int axis : {0, 1})
      for (const double limit : {box.low[axis], box.high[axis]})
        if ((a[axis] < limit) != (b[axis] < limit))
          cuts[count++] = (limit - a[axis]) / (b[axis] - a[axis]);
    std::sort(cuts.begin(), cuts.begin() + static_cast<std::ptrdiff_t>(count));
    for (std::size_t k = 0; k < count; ++k)
      moved.push_back((a + cuts[k] * (b - a)).cwiseMax(box.low).cwiseMin(box.high));
  }
  return moved;
}

}  // namespace flatray::gl
