#include "oracle/exact_coverage.h"

#include <algorithm>

#include "oracle/point.h"

namespace flatray {
namespace {

using oracle::Point;
using Ring = std::vector<Point>;

// Sutherland and Hodgman: the part of a ring where `depth` of a point is not negative.
template <class Depth>
Ring clip(const Ring& ring, const Depth& depth) {
  Ring out;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &p = ring[i], &q = ring[(i + 1) % ring.size()];
    const Rational dp = depth(p), dq = depth(q);
    if (dp >= 0) out.push_back(p);
    if ((dp > 0 && dq < 0) || (dp < 0 && dq > 0)) {
      const Rational t = dp / (dp - dq);
      out.push_back(p + t * (q - p));
    }
  }
  return out;
}

Ring clip_to_pixel(const std::vector<Vec2>& piece, int x, int y) {
  Ring ring;
  for (const Vec2& v : piece) ring.push_back(oracle::exact(v));
  ring = clip(ring, [&](const Point& p) { return p.x - x; });
  ring = clip(ring, [&](const Point& p) { return Rational(x + 1.0) - p.x; });
  ring = clip(ring, [&](const Point& p) { return p.y - y; });
  return clip(ring, [&](const Point& p) { return Rational(y + 1.0) - p.y; });
}

bool misses(const std::vector<Vec2>& piece, int x, int y) {
  const auto all = [&](auto outside) { return std::all_of(piece.begin(), piece.end(), outside); };
  return all([&](const Vec2& v) { return v.x() <= x; }) ||
         all([&](const Vec2& v) { return v.x() >= x + 1.0; }) ||
         all([&](const Vec2& v) { return v.y() <= y; }) ||
         all([&](const Vec2& v) { return v.y() >= y + 1.0; });
}

// Every x at which two sides of any rings cross, and every corner's.
std::vector<Rational> slab_borders(const std::vector<Ring>& rings) {
  std::vector<Rational> borders;
  std::vector<std::pair<const Point*, const Point*>> sides;
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      borders.push_back(ring[i].x);
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
      if (t > 0 && t < 1) borders.push_back(a->x + t * u.x);
    }
  std::sort(borders.begin(), borders.end());
  borders.erase(std::unique(borders.begin(), borders.end()), borders.end());
  return borders;
}

struct Span {
  Rational low, high;
};

// Where the upright line at x, through no corner, is inside a convex ring.
std::vector<Span> spans_at(const std::vector<Ring>& rings, const Rational& x) {
  std::vector<Span> spans;
  for (const Ring& ring : rings) {
    std::vector<Rational> ys;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &p = ring[i], &q = ring[(i + 1) % ring.size()];
      if ((p.x < x) != (q.x < x)) ys.push_back(p.y + (x - p.x) / (q.x - p.x) * (q.y - p.y));
    }
    if (ys.size() < 2) continue;
    const auto [low, high] = std::minmax_element(ys.begin(), ys.end());
    spans.push_back({*low, *high});
  }
  return spans;
}

Rational union_length(std::vector<Span> spans) {
  std::sort(spans.begin(), spans.end(), [](const Span& a, const Span& b) { return a.low < b.low; });
  Rational sum, reached;
  bool any = false;
  for (const Span& span : spans) {
    if (!any || span.low > reached) reached = span.low, any = true;
    if (span.high > reached) sum += span.high - reached, reached = span.high;
  }
  return sum;
}

Rational odd_length(const std::vector<Span>& spans) {
  std::vector<Rational> ends;
  for (const Span& span : spans) ends.push_back(span.low), ends.push_back(span.high);
  std::sort(ends.begin(), ends.end());
  Rational sum;
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2) sum += ends[i + 1] - ends[i];
  return sum;
}

// Of what `length` measures on the upright lines through a pixel.
template <class Length>
Rational area_of(std::span<const std::vector<Vec2>> pieces, int x, int y, const Length& length) {
  std::vector<Ring> rings;
  for (const std::vector<Vec2>& piece : pieces) {
    if (misses(piece, x, y)) continue;
    Ring ring = clip_to_pixel(piece, x, y);
    if (ring.size() >= 3) rings.push_back(std::move(ring));
  }
  const std::vector<Rational> borders = slab_borders(rings);
  Rational area;
  for (std::size_t i = 0; i + 1 < borders.size(); ++i)
    area += (borders[i + 1] - borders[i]) *
            length(spans_at(rings, (borders[i] + borders[i + 1]) * Rational(0.5)));
  return area;
}

}  // namespace

Rational exact_union_area(std::span<const std::vector<Vec2>> pieces, int x, int y) {
  return area_of(pieces, x, y, &union_length);
}

Rational exact_odd_area(std::span<const std::vector<Vec2>> pieces, int x, int y) {
  return area_of(pieces, x, y, &odd_length);
}

}  // namespace flatray
