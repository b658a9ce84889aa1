#include "oracle/exact_coverage.h"

#include <algorithm>

#include "geom/bounds.h"
#include "oracle/point.h"

namespace flatray {
namespace {

using oracle::Point;
using Ring = std::vector<Point>;

// Every x at which two sides of any rings cross inside the pixel, and that of every corner there.
std::vector<Rational> slab_borders(const std::vector<Ring>& rings, const Bounds& pixel) {
  std::vector<Rational> borders;
  const auto add = [&](const Point& p) {
    if (p.x >= pixel.low.x() && p.x <= pixel.high.x() && p.y >= pixel.low.y() &&
        p.y <= pixel.high.y())
      borders.push_back(p.x);
  };
  std::vector<std::pair<const Point*, const Point*>> sides;
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      add(ring[i]);
      sides.emplace_back(&ring[i], &ring[(i + 1) % ring.size()]);
    }
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t k = i + 1; k < sides.size(); ++k) {
      const auto& [a, b] = sides[i];
      const auto& [c, d] = sides[k];
      const Point u = *b - *a, v = *d - *c;
      const Rational det = cross(u, v);
      if (det == 0) continue;
      const Rational t = cross(*c - *a, v) / det;
      if (t > 0 && t < 1) add(*a + t * u);
    }
  std::sort(borders.begin(), borders.end());
  borders.erase(std::unique(borders.begin(), borders.end()), borders.end());
  return borders;
}

// Of the upright line at x, through no corner, what lies in the pixel and in so many convex rings that
// `counts(rings)`.
template <class Counts>
Rational length_at(const std::vector<Ring>& rings, const Rational& x, const Bounds& pixel,
                   const Counts& counts) {
  std::vector<std::pair<Rational, int>> ends;  // and the rings more from there on
  for (const Ring& ring : rings) {
    std::vector<Rational> ys;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &p = ring[i], &q = ring[(i + 1) % ring.size()];
      if ((p.x < x) == (q.x < x)) continue;
      const Rational y = p.y + (x - p.x) / (q.x - p.x) * (q.y - p.y);
      ys.push_back(std::clamp<Rational>(y, pixel.low.y(), pixel.high.y()));
    }
    if (ys.size() < 2) continue;
    const auto [low, high] = std::minmax_element(ys.begin(), ys.end());
    ends.emplace_back(*low, 1), ends.emplace_back(*high, -1);
  }
  std::sort(ends.begin(), ends.end());
  Rational sum;
  int inside = 0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    inside += ends[i].second;
    if (counts(inside)) sum += ends[i + 1].first - ends[i].first;
  }
  return sum;
}

template <class Counts>
Rational area_of(std::span<const std::vector<Vec2>> pieces, int x, int y, const Counts& counts) {
  const Bounds pixel{Vec2(x, y), Vec2(x + 1.0, y + 1.0)};
  std::vector<Ring> rings;
  for (const std::vector<Vec2>& piece : pieces)
    if (box_about(piece).meets(pixel)) rings.push_back(oracle::exact_ring(piece));
  std::vector<Ring> all = rings;
  all.push_back(oracle::exact_ring(pixel.corners()));
  const std::vector<Rational> borders = slab_borders(all, pixel);
  Rational area;
  for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
    const Rational middle = (borders[i] + borders[i + 1]) * Rational(0.5);
    area += (borders[i + 1] - borders[i]) * length_at(rings, middle, pixel, counts);
  }
  return area;
}

}  // namespace

Rational exact_union_area(std::span<const std::vector<Vec2>> pieces, int x, int y) {
  return area_of(pieces, x, y, [](int inside) { return inside > 0; });
}

Rational exact_odd_area(std::span<const std::vector<Vec2>> pieces, int x, int y) {
  return area_of(pieces, x, y, [](int inside) { return inside % 2 != 0; });
}

}  // namespace flatray
