#include "render/coverage_cell.h"

#include <algorithm>
#include <cmath>

namespace flatray {
namespace {

constexpr double kUlp = 0x1p-52;

struct SignedArea {
  double area;   // integral of the winding number, without that of the corner
  double bound;  // of its error
  int pieces = 0;
};

// A piece raises the winding right of it; where an edge crosses the left border, the winding along
// that border changes from there down. Each end of a piece moves the sum by at most half its own
// error, the clamped corner cuts by as much again; each term is rounded a few times.
SignedArea signed_area(std::span<const Piece> pieces) {
  SignedArea sum{0, 0};
  for (const Piece& p : pieces) {
    sum.bound += 4 * p.error + (p.exact ? 0 : 8 * kUlp);
    if (p.ghost) continue;
    ++sum.pieces;
    double share = (p.y_bottom - p.y_top) * (1 - 0.5 * (p.x_top + p.x_bottom));
    if (p.left_top) share -= 1 - p.y_top;
    if (p.left_bottom) share += 1 - p.y_bottom;
    sum.area += p.direction * share;
  }
  if (sum.bound > 0) sum.bound += kUlp * sum.pieces * sum.pieces;
  return sum;
}

// One edge from border to border parts the pixel into two windings.
CellArea parted_area(const SignedArea& sum, int winding, FillRule rule) {
  const int other = sum.area > 0 ? winding + 1 : winding - 1, opposite = 2 * winding - other;
  const bool here = covers(rule, winding), there = covers(rule, other);
  const double share = std::min(std::abs(sum.area), 1.0);
  if (here == there) {
    const bool certain = share > sum.bound || covers(rule, opposite) == there;
    return {here ? 1.0 : 0.0, sum.bound, here && certain};
  }
  return {here ? 1 - share : share, sum.bound + (sum.bound > 0 ? kUlp : 0), false};
}

}  // namespace

CellArea simple_area(std::span<const Piece> pieces, int winding) {
  const SignedArea sum = signed_area(pieces);
  const double area = std::abs(winding + sum.area);
  return {std::min(area, 1.0), sum.bound + (sum.bound > 0 ? kUlp : 0), false};
}

CellArea cell_area(std::span<const Piece> pieces, int winding, FillRule rule, SlabWork& work) {
  if (pieces.size() == 1) {
    const SignedArea sum = signed_area(pieces);
    if (sum.pieces == 1) return parted_area(sum, winding, rule);
    return {covers(rule, winding) ? 1.0 : 0.0, sum.bound, false};
  }
  return slab_area(pieces, winding, rule, work);
}

std::optional<std::uint32_t> certain_steps(const CellArea& area) {
  if (area.full) return kFullCoverage;
  const double steps = kFullCoverage * area.area;
  if (area.bound == 0) return static_cast<std::uint32_t>(steps);
  const double slack = kFullCoverage * area.bound + 0x1p-36;  // and half an ulp of `steps`
  const double low = std::floor(std::max(steps - slack, 0.0));
  const double high = std::floor(std::min<double>(steps + slack, kFullCoverage));
  if (low != high) return std::nullopt;
  return static_cast<std::uint32_t>(low);
}

}  // namespace flatray
