#include <algorithm>
#include <cmath>

#include "render/coverage_scan.h"

namespace flatray {
namespace {

// A row of centres is a ray: where an edge crosses it, the winding changes from the first centre on
// or right of the edge.
struct Step {
  int row, column, change;
};

// Whether the centre of a column lies on or right of an edge that spans the row of centres at y.
bool right_of(const ScanEdge& e, int column, double y) {
  const Rational dx = Rational(e.x_bottom) - Rational(e.x_top);
  const Rational dy = Rational(e.y_bottom) - Rational(e.y_top);
  const Rational along = (Rational(y) - Rational(e.y_top)) * dx;
  return (Rational(column + 0.5) - Rational(e.x_top)) * dy >= along;
}

// First column of the box, or the one past its end, whose centre is on or right of the edge.
int first_right(const ScanEdge& e, double y, const PixelBox& box, CoverageStats& stats) {
  const double x = y == e.y_top ? e.x_top : e.x_at(y);
  const double error = y == e.y_top ? 0 : e.error_x;
  const double begin = box.x, end = box.x + box.width;
  // A margin of an ulp for the sums here.
  const double slack = error > 0 ? error + 0x1p-52 * std::abs(x) : 0;
  double low = std::clamp(std::ceil(x - 0.5 - slack), begin, end);
  double high = std::clamp(std::ceil(x - 0.5 + slack), begin, end);
  if (low < high) ++stats.exact_fallbacks;
  while (low < high) {
    const double middle = std::floor(0.5 * (low + high));
    if (right_of(e, static_cast<int>(middle), y))
      high = middle;
    else
      low = middle + 1;
  }
  return static_cast<int>(low);
}

void add_steps(const Segment& edge, const PixelBox& box, std::vector<Step>& steps,
               CoverageStats& stats) {
  const auto [top, bottom] = std::minmax(edge.a.y(), edge.b.y());
  // Rows with top <= row + 1/2 < bottom. Both sides are compared as they stand: row + 1/2 is exact.
  if (top >= box.y + box.height || bottom <= box.y) return;
  const ScanEdge ready = scan_edge(edge, box);
  int row = static_cast<int>(std::floor(std::max<double>(top, box.y)));
  if (row + 0.5 < top) ++row;
  for (; row < box.y + box.height && row + 0.5 < bottom; ++row) {
    const int column = first_right(ready, row + 0.5, box, stats);
    if (column < box.x + box.width) steps.push_back({row, column, ready.direction});
  }
}

}  // namespace

void scan_centres(const FillPath& path, const std::vector<std::uint32_t>* chosen,
                  const PixelBox& box, RunList& out, CoverageStats& stats) {
  std::vector<Step> steps;
  if (chosen == nullptr)
    for (const Segment& edge : path.edges) add_steps(edge, box, steps, stats);
  else
    for (const std::uint32_t index : *chosen) add_steps(path.edges[index], box, steps, stats);
  std::sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) {
    return a.row != b.row ? a.row < b.row : a.column < b.column;
  });
  stats.edge_pixels += steps.size();
  int winding = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    winding += steps[i].change;
    const bool last = i + 1 == steps.size() || steps[i + 1].row != steps[i].row;
    if (covers(path.rule, winding))
      out.add(steps[i].row, steps[i].column, last ? box.x + box.width : steps[i + 1].column,
              kFullCoverage);
    if (last) winding = 0;
  }
}

}  // namespace flatray
