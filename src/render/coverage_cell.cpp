#include "render/coverage_cell.h"

namespace flatray {
namespace {

// One edge from border to border parts the pixel into two windings.
CellArea parted_area(const Share& sum, int winding, FillRule rule) {
  const int other = sum.area > 0 ? winding + 1 : winding - 1, opposite = 2 * winding - other;
  const bool here = covers(rule, winding), there = covers(rule, other);
  const double share = std::min(std::abs(sum.area), 1.0);
  if (here == there) {
    const bool certain = share > sum.bound || covers(rule, opposite) == there;
    return {here ? 1.0 : 0.0, sum.bound, here && certain};
  }
  return {here ? 1 - share : share, sum.bound, false};
}

}  // namespace

CellArea cell_area(std::span<const Piece> pieces, int winding, FillRule rule, SlabWork& work) {
  constexpr std::size_t kMany = 8;  // from here on the bounds cost less than the slabs
  if (pieces.size() >= kMany && rule == FillRule::nonzero && certainly_full(pieces, winding))
    return {1, 0, true};
  if (pieces.size() > 1) return slab_area(pieces, winding, rule, work);
  const Share share = share_of(pieces.front());
  if (pieces.front().ghost) return {covers(rule, winding) ? 1.0 : 0.0, share.bound, false};
  return parted_area(share, winding, rule);
}

}  // namespace flatray
