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

// Winding and crossings along the middles of the strips of one pixel. An edge passes the pixel's left
// border once: of the strips it spans it is left of the pixel in the first or in the last ones.
class Strips {
 public:
  Strips(std::span<const ScanEdge> edges, int winding, int column, int row, FillRule rule)
      : column_(column), row_(row), rule_(rule) {
    for (int i = 0; i < kStrips; ++i) middles_.push_back(row_ + (i + 0.5) / kStrips);
    changes_.resize(middles_.size() + 1);
    changes_[0] = winding;
    for (const ScanEdge& e : edges) add(e);
  }

  double area() {
    double sum = 0;
    int winding = 0;
    for (std::size_t i = 0; i < middles_.size(); ++i) sum += covered(i, winding += changes_[i]);
    return sum / kStrips;
  }

 private:
  // What an edge does inside the pixel, in strips [begin, end).
  struct Inside {
    const ScanEdge* edge;
    std::size_t begin, end;
    double slope;
  };

  void add(const ScanEdge& e) {
    const auto first = [&](double y) {
      return std::upper_bound(middles_.begin(), middles_.end(), y);
    };
    const auto top = first(e.y_top), bottom = first(e.y_bottom);
    const bool rightward = e.x_top < e.x_bottom;
    const auto passes =
        std::partition_point(top, bottom, [&](double y) { return is_left(e, y) == rightward; });
    const std::size_t begin = index(top), change = index(passes), end = index(bottom);
    const bool left_before = e.y_top <= row_ ? begins_left(e) : e.x_top < column_;
    const bool left_after = e.x_bottom < column_;
    if (e.y_top <= row_ && row_ < e.y_bottom && left_before) changes_[0] += e.direction;
    const Inside inside{&e, rightward ? change : begin, rightward ? end : change,
                        (e.x_bottom - e.x_top) / (e.y_bottom - e.y_top)};
    if (left_before)
      count(inside.begin, inside.end, -e.direction);
    else
      count(rightward ? begin : change, rightward ? change : end, e.direction);
    if (left_after != left_before)
      count(end, middles_.size(), left_after ? e.direction : -e.direction);
    if (inside.begin < inside.end) inside_.push_back(inside);
  }
  std::size_t index(std::vector<double>::const_iterator strip) const {
    return static_cast<std::size_t>(strip - middles_.begin());
  }
  void count(std::size_t begin, std::size_t end, int change) {
    changes_[begin] += change;
    changes_[end] -= change;
  }

  double covered(std::size_t strip, int winding) {
    crossings_.clear();
    for (const Inside& one : inside_)
      if (one.begin <= strip && strip < one.end)
        crossings_.emplace_back(x_of(one, middles_[strip]), one.edge->direction);
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
  double x_of(const Inside& one, double y) const {
    return std::clamp(one.edge->x_top + (y - one.edge->y_top) * one.slope - column_, 0.0, 1.0);
  }

  const double column_, row_;
  const FillRule rule_;
  std::vector<double> middles_;
  std::vector<int> changes_;  // of the winding along the left border, before each strip
  std::vector<Inside> inside_;
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
  const double area = Strips(edges, winding, column, row, rule).area();
  return static_cast<std::uint32_t>(std::min(area, 1.0) * kFullCoverage + 0.5);
}

}  // namespace flatray
