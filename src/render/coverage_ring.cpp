#include <algorithm>
#include <cmath>

#include "render/circle_segment.h"
#include "render/coverage_scan.h"

namespace flatray {
namespace {

// Everything is measured from the centre and by absolute values, so that a mirrored disc has
// mirrored coverage.

// Half a chord at distance d from the centre of a circle; 0 outside. (r - d)(r + d) does not
// cancel.
double half_chord(double r, double d) { return d < r ? std::sqrt((r - d) * (r + d)) : 0; }

// Part of a box in the first quadrant inside the disc, where the arc falls from the left to the
// right.
double quadrant_area(double r, double x0, double x1, double y0, double y1) {
  const double y_right = std::clamp(half_chord(r, x1), y0, y1);
  const double y_left = std::clamp(half_chord(r, x0), y0, y1);
  double area = (y_right - y0) * (x1 - x0);
  if (y_left <= y_right) return area;
  const double x_low = std::clamp(half_chord(r, y_right), x0, x1);
  const double x_high = std::clamp(half_chord(r, y_left), x0, x1);
  area += (y_left - y_right) * (0.5 * (x_low + x_high) - x0);
  const double dx = x_low - x_high, dy = y_left - y_right;
  return area + circle_segment(r, std::sqrt(dx * dx + dy * dy));
}

struct Reach {
  double near, far;  // least and greatest distance of an interval's points from 0
  Reach(double low, double high)
      : near(low > 0    ? low
             : high < 0 ? -high
                        : 0),
        far(std::max(std::abs(low), std::abs(high))) {}
};

double half_plane_area(double r, double x0, double x1, double y0, double y1) {
  if (y0 >= 0) return quadrant_area(r, x0, x1, y0, y1);
  if (y1 <= 0) return quadrant_area(r, x0, x1, -y1, -y0);
  return quadrant_area(r, x0, x1, 0, -y0) + quadrant_area(r, x0, x1, 0, y1);
}

// Part of a pixel, seen from the centre, inside the disc.
double disc_area(double r, double x0, double x1, double y0, double y1) {
  if (!(r > 0)) return 0;
  const Reach x(x0, x1), y(y0, y1);
  if (x.far * x.far + y.far * y.far <= r * r) return 1;
  if (x.near * x.near + y.near * y.near >= r * r) return 0;
  if (x0 >= 0) return half_plane_area(r, x0, x1, y0, y1);
  if (x1 <= 0) return half_plane_area(r, -x1, -x0, y0, y1);
  return half_plane_area(r, 0, -x0, y0, y1) + half_plane_area(r, 0, x1, y0, y1);
}

// Columns in which a row may meet a circle, left and right of the centre; between them lies the
// disc.
struct Arcs {
  int left_begin, left_end, right_begin, right_end;
};

int column(double x, const PixelBox& box) {
  return static_cast<int>(std::clamp<double>(std::floor(x), box.x - 1.0, box.x + box.width + 1.0));
}

// A column of margin on each side: the half chords are rounded.
Arcs arcs(double r, double cx, const Reach& y, const PixelBox& box) {
  if (!(y.near < r)) return {box.x, box.x, box.x, box.x};
  const double out = half_chord(r, y.near), in = half_chord(r, y.far);
  Arcs a{column(cx - out, box) - 1, column(cx - in, box) + 2, column(cx + in, box) - 1,
         column(cx + out, box) + 2};
  if (a.right_begin < a.left_end) a.left_end = a.right_begin = a.right_end;
  return a;
}

bool inside(const Arcs& a, int x) { return x >= a.left_end && x < a.right_begin; }

void area_row(const FillRing& ring, int row, const PixelBox& box, RunList& out,
              CoverageStats& stats) {
  const double cx = ring.centre.x(), cy = ring.centre.y();
  const double y0 = row - cy, y1 = row + 1.0 - cy;
  const Reach y(y0, y1);
  const Arcs outer = arcs(ring.radius, cx, y, box), inner = arcs(ring.inner_radius, cx, y, box);
  const int end = box.x + box.width;
  int x = std::max(box.x, outer.left_begin);
  while (x < end && x < outer.right_end) {
    // Next column at which anything begins or ends.
    int next = end;
    bool edge = false;
    for (const Arcs& a : {outer, inner})
      for (const auto& [from, to] :
           {std::pair(a.left_begin, a.left_end), std::pair(a.right_begin, a.right_end)}) {
        edge = edge || (x >= from && x < to);
        if (from > x) next = std::min(next, from);
        if (to > x) next = std::min(next, to);
      }
    if (!edge && inside(outer, x) && !inside(inner, x)) out.add(row, x, next, kFullCoverage);
    for (; edge && x < next; ++x) {
      const double x0 = x - cx, x1 = x + 1.0 - cx;
      const double area =
          disc_area(ring.radius, x0, x1, y0, y1) - disc_area(ring.inner_radius, x0, x1, y0, y1);
      out.add(row, x, x + 1,
              static_cast<std::uint32_t>(kFullCoverage * std::clamp(area, 0.0, 1.0)));
      ++stats.edge_pixels;
    }
    x = next;
  }
}

// Sign of the distance of a pixel centre from the circle: squares in doubles, rationals where their
// error could matter.
Sign circle_side(const Vec2& centre, double r, double px, double py, CoverageStats& stats) {
  const double dx = px - centre.x(), dy = py - centre.y();
  const double difference = dx * dx + dy * dy - r * r;
  // Differences carry u of their value, squares three times that, the sums one more of each part.
  const double bound = 0x1p-50 * (dx * dx + dy * dy + r * r);
  if (std::abs(difference) > bound) return sign_of(difference);
  ++stats.exact_fallbacks;
  const Rational ex = Rational(px) - Rational(centre.x()), ey = Rational(py) - Rational(centre.y());
  return (ex * ex + ey * ey - Rational(r) * Rational(r)).sign();
}

struct Columns {
  int begin, end;
};

// First of the columns in [low, high) that is `there`; they all are from it on.
template <class There>
int first_column(int low, int high, const There& there) {
  while (low < high) {
    const int middle = low + (high - low) / 2;
    if (there(middle))
      high = middle;
    else
      low = middle + 1;
  }
  return low;
}

// A circle is half open like an edge: its left half belongs to the disc, its right half does not.
Columns disc_columns(const Vec2& centre, double r, int row, const PixelBox& box,
                     CoverageStats& stats) {
  const int end = box.x + box.width;
  const double py = row + 0.5;
  if (!(r > 0) || std::abs(py - centre.y()) > r) return {end, end};
  const double axis = std::ceil(centre.x() - 0.5);  // first centre on or right of the disc's
  const int middle = static_cast<int>(std::clamp<double>(axis, box.x, end));
  const int left = first_column(box.x, middle, [&](int x) {
    return circle_side(centre, r, x + 0.5, py, stats) != Sign::positive;
  });
  const int right = first_column(middle, end, [&](int x) {
    return circle_side(centre, r, x + 0.5, py, stats) != Sign::negative;
  });
  return {left, right};
}

void centre_row(const FillRing& ring, int row, const PixelBox& box, RunList& out,
                CoverageStats& stats) {
  const Columns outer = disc_columns(ring.centre, ring.radius, row, box, stats);
  const Columns inner = disc_columns(ring.centre, ring.inner_radius, row, box, stats);
  if (inner.begin >= inner.end) return out.add(row, outer.begin, outer.end, kFullCoverage);
  out.add(row, outer.begin, inner.begin, kFullCoverage);
  out.add(row, inner.end, outer.end, kFullCoverage);
}

}  // namespace

void scan_ring(const FillRing& ring, Coverage mode, const PixelBox& box, RunList& out,
               CoverageStats& stats) {
  const double top = ring.centre.y() - ring.radius - 1, bottom = ring.centre.y() + ring.radius + 1;
  for (int row = box.y; row < box.y + box.height; ++row) {
    if (row < top - 1 || row > bottom) continue;
    if (mode == Coverage::area)
      area_row(ring, row, box, out, stats);
    else
      centre_row(ring, row, box, out, stats);
  }
}

}  // namespace flatray
