#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "geom/bounds.h"
#include "trace/curve_cells.h"
#include "trace/surfaces.h"

namespace flatray {

/// The walls of a scene by the cells of a grid, to ask which come near a point.
///
/// Few walls, and those whose coordinates leave no room for sound arithmetic, are in no cells: all
/// of them are looked at.
///
/// Cost    O(n) to build, some 30 bytes a wall; a question looks at the walls of a cell or two.
class WallCells {
 public:
  /// Needs   `walls` to outlive it, and to stay as they are.
  explicit WallCells(const Surfaces& walls);

  /// Those walls for which `keep` holds, ascending, among walls of which every one is that comes
  /// within `reach` of a point in both coordinates.
  ///
  /// Needs   a reach of 4 ulps of the point at most.
  template <class Keep>
  std::vector<std::uint32_t> near(const Vec2& point, const Vec2& reach, const Keep& keep) const {
    std::vector<std::uint32_t> found;
    const auto offer = [&](std::uint32_t surface) {
      if (keep(surface)) found.push_back(surface);
    };
    if (side_ == 0)
      for (const std::uint32_t surface : walls_.segment_numbers) offer(surface);
    else
      visit_cells({point - reach, point + reach}, [&](std::size_t cell) {
        for (std::uint32_t i = begin_[cell]; i < begin_[cell + 1]; ++i) offer(segments_[i]);
      });
    curves_.visit_near(point, offer);
    if (found.size() > 1) {
      std::sort(found.begin(), found.end());
      found.erase(std::unique(found.begin(), found.end()), found.end());
    }
    return found;
  }

  /// As Accelerator::structure() and cells().
  std::string structure() const;
  std::size_t cells() const { return side_ * side_ + curves_.cells(); }
  /// Segments in all cells together.
  std::size_t entries() const { return segments_.size(); }

 private:
  // Never falls as a place grows, whatever is rounded: boxes that meet have a cell in common.
  std::size_t column(int axis, double place) const {
    const double at = (place - low_[axis]) * scale_[axis];
    return at > 0 ? std::min(static_cast<std::size_t>(std::min(at, 0x1p30)), side_ - 1) : 0;
  }
  template <class Visit>
  void visit_cells(const Bounds& box, const Visit& visit) const {
    const std::size_t left = column(0, box.low.x()), right = column(0, box.high.x());
    const std::size_t top = column(1, box.high.y());
    for (std::size_t y = column(1, box.low.y()); y <= top; ++y)
      for (std::size_t x = left; x <= right; ++x) visit(y * side_ + x);
  }
  std::vector<std::size_t> cells_of(const Segment& wall) const;
  bool divide();
  void fill();

  const Surfaces& walls_;
  std::size_t side_ = 0;  // cells along each axis; 0: none
  Vec2 low_{0, 0}, scale_{0, 0};
  double slack_ = 0;                  // that rounding of places along a wall needs
  std::vector<std::uint32_t> begin_;  // of each cell in segments_, and the end of the last
  std::vector<std::uint32_t> segments_;
  CurveCells curves_;
};

}  // namespace flatray
