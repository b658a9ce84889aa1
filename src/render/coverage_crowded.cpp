#include "render/coverage_crowded.h"

#include <algorithm>
#include <utility>

#include "geom/predicates.h"
#include "render/coverage_cell.h"

namespace flatray {
namespace {

// Side of a point seen from the edge's upper to its lower end: in film coordinates, y down, what
// lies left of an edge in the picture is on its positive side.
Sign side(const ScanEdge& e, double x, double y) {
  return orientation({e.x_top, e.y_top}, {e.x_bottom, e.y_bottom}, {x, y});
}

bool meets_inside(const ScanEdge& e, int column, int row) {
  const double left = column, right = column + 1.0, top = row, bottom = row + 1.0;
  const auto [low, high] = std::minmax(e.x_top, e.x_bottom);
  const bool level = e.y_top == e.y_bottom, upright = low == high;
  if (level ? e.y_top <= top || e.y_top >= bottom : e.y_bottom <= top || e.y_top >= bottom)
    return false;
  if (upright ? low <= left || low >= right : high <= left || low >= right) return false;
  bool some = false, others = false;
  for (const double x : {left, right})
    for (const double y : {top, bottom}) {
      const Sign at = side(e, x, y);
      some = some || at == Sign::positive;
      others = others || at == Sign::negative;
    }
  return some && others;
}

// Winding and crossings along the middles of the strips of one pixel.
class Strips {
 public:
  Strips(std::span<const ScanEdge> edges, int winding, int column, int row, FillRule rule)
      : edges_(edges), winding_(winding), column_(column), row_(row), rule_(rule) {
    for (const ScanEdge& e : edges_)
      if (e.y_top <= row_ && row_ < e.y_bottom && begins_left(e)) winding_ += e.direction;
  }

  double covered(double y) {
    int winding = winding_;
    crossings_.clear();
    for (const ScanEdge& e : edges_) {
      if (e.y_top >= y) continue;
      const bool spans = y <= e.y_bottom;
      const bool left_now = spans ? is_left(e, y) : e.x_bottom < column_;
      const bool left_before = e.y_top <= row_ ? begins_left(e) : e.x_top < column_;
      if (left_now != left_before) winding += left_now ? e.direction : -e.direction;
      if (spans && !left_now) crossings_.emplace_back(x_of(e, y), e.direction);
    }
    std::sort(crossings_.begin(), crossings_.end());
    double width = 0, from = 0;
    bool inside = covers(rule_, winding);
    for (const auto& [x, direction] : crossings_) {
      winding += direction;
      if (covers(rule_, winding) == inside) continue;
      if (inside) width += x - from;
      inside = !inside;
      from = x;
    }
    return inside ? width + (1 - from) : width;
  }

 private:
  // Left of the pixel's left border, at a height the edge reaches.
  bool is_left(const ScanEdge& e, double y) const {
    if (std::max(e.x_top, e.x_bottom) < column_) return true;
    if (std::min(e.x_top, e.x_bottom) >= column_) return false;
    return side(e, column_, y) == Sign::negative;
  }
  // At the row's upper border; one that passes through the corner, if it goes on to the left.
  bool begins_left(const ScanEdge& e) const {
    const bool corner_taken = e.x_bottom < e.x_top && side(e, column_, row_) == Sign::zero;
    return corner_taken || is_left(e, row_);
  }
  double x_of(const ScanEdge& e, double y) const {
    const double slope = (e.x_bottom - e.x_top) / (e.y_bottom - e.y_top);
    return std::clamp(e.x_top + (y - e.y_top) * slope - column_, 0.0, 1.0);
  }

  std::span<const ScanEdge> edges_;
  int winding_;
  const double column_, row_;
  const FillRule rule_;
  std::vector<std::pair<double, int>> crossings_;
};

}  // namespace

bool is_crowded(std::span<const ScanEdge> edges, int column, int row) {
  std::size_t inside = 0;
  for (const ScanEdge& e : edges) inside += meets_inside(e, column, row) ? 1 : 0;
  return inside > kCrowd;
}

std::uint32_t crowded_steps(std::span<const ScanEdge> edges, int winding, int column, int row,
                            FillRule rule) {
  Strips strips(edges, winding, column, row, rule);
  double area = 0;
  for (int i = 0; i < kStrips; ++i) area += strips.covered(row + (i + 0.5) / kStrips);
  return static_cast<std::uint32_t>(std::min(area / kStrips, 1.0) * kFullCoverage + 0.5);
}

}  // namespace flatray
