#include "render/gl/outlines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/portable_math.h"
#include "render/gl/grid.h"

namespace flatray::gl {
namespace {

bool before(const Vec2& a, const Vec2& b) {
  return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

// Finds an edge not yet used that starts at a point.
class Starts {
 public:
  explicit Starts(std::span<const Segment> edges)
      : edges_(edges), order_(edges.size()), used_(edges.size()) {}

  std::size_t next(std::size_t edge) {
    const Vec2& end = edges_[edge].b;
    if (edge + 1 < edges_.size() && !used_[edge + 1] && edges_[edge + 1].a == end) return edge + 1;
    sort();
    const auto starts_before = [&](std::size_t i, const Vec2& p) { return before(edges_[i].a, p); };
    auto found = std::lower_bound(order_.begin(), order_.end(), end, starts_before);
    while (found != order_.end() && used_[*found] && edges_[*found].a == end) ++found;
    return found != order_.end() && edges_[*found].a == end ? *found : edges_.size();
  }
  bool used(std::size_t edge) const { return used_[edge]; }
  void use(std::size_t edge) { used_[edge] = true; }

 private:
  void sort() {
    if (sorted_) return;
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::sort(order_.begin(), order_.end(), [&](std::size_t i, std::size_t k) {
      return before(edges_[i].a, edges_[k].a) || (edges_[i].a == edges_[k].a && i < k);
    });
    sorted_ = true;
  }

  std::span<const Segment> edges_;
  std::vector<std::size_t> order_;
  std::vector<bool> used_;
  bool sorted_ = false;
};

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
  if (sagitta * kGridSteps <= 1 || !meet({reach.low - margin, reach.high + margin}, box)) {
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

std::vector<Ring> rings_of(std::span<const Segment> edges) {
  std::vector<Ring> rings;
  Starts starts(edges);
  for (std::size_t first = 0; first < edges.size(); ++first) {
    if (starts.used(first)) continue;
    Ring& ring = rings.emplace_back();
    for (std::size_t edge = first; edge < edges.size();) {
      starts.use(edge);
      ring.push_back(edges[edge].a);
      if (edges[edge].b == edges[first].a) break;
      edge = starts.next(edge);
    }
  }
  return rings;
}

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

Bounds bounds_of(std::span<const Vec2> points) {
  Bounds bounds;
  for (const Vec2& point : points) bounds.add(point);
  return bounds;
}

bool contains(const Bounds& outer, const Bounds& inner) {
  return outer.low.x() <= inner.low.x() && outer.low.y() <= inner.low.y() &&
         inner.high.x() <= outer.high.x() && inner.high.y() <= outer.high.y();
}

bool meet(const Bounds& a, const Bounds& b) {
  return a.low.x() <= b.high.x() && b.low.x() <= a.high.x() && a.low.y() <= b.high.y() &&
         b.low.y() <= a.high.y();
}

}  // namespace flatray::gl
