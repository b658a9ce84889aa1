#pragma once
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "geom/bounds.h"
#include "trace/cell_raster.h"
#include "trace/surfaces.h"

namespace flatray {

/// Walls of any kind by the cells of a grid that they pass, to ask which come near a point.
///
/// Gives   lists that hold every wall within 2^-10 of a cell's side of it; some 2 cells a wall.
///         Few walls, and those whose coordinates leave no room for sound arithmetic, are in no
///         cells: all of them are looked at.
/// Cost    to build O(n): walls pass some dozen cells on average, of a wider grid where they overlap.
class WallCells {
 public:
  /// Needs   `walls` to outlive it, and to stay as they are.
  explicit WallCells(const Surfaces& walls);

  /// Those walls for which `keep` holds, ascending, among walls of which every one is that comes within 4 ulps
  /// of a point.
  template <class Keep>
  std::vector<std::uint32_t> near(const Vec2& point, const Keep& keep) const {
    std::vector<std::uint32_t> found;
    const auto offer = [&](std::uint32_t wall) {
      if (keep(wall)) found.push_back(wall);
    };
    if (begin_.empty()) {
      visit_all(offer);
      return found;
    }
    const CellRect near = cells_of({point, point});
    for (int y = near.bottom; y < near.bottom + near.height; ++y)
      for (int x = near.left; x < near.left + near.width; ++x) {
        const std::size_t cell = static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
                                 static_cast<std::size_t>(x);
        for (std::uint32_t i = begin_[cell]; i < begin_[cell + 1]; ++i) offer(listed_[i]);
      }
    if (found.size() > 1) {
      std::sort(found.begin(), found.end());
      found.erase(std::unique(found.begin(), found.end()), found.end());
    }
    return found;
  }
  /// As Accelerator::structure() and cells().
  std::string structure() const;
  std::size_t cells() const { return begin_.empty() ? 0 : begin_.size() - 1; }
  /// Walls in all cells together.
  std::size_t entries() const { return listed_.size(); }
  std::size_t bytes() const { return 4 * (begin_.size() + listed_.size()); }

 private:
  template <class Visit>
  void visit_all(const Visit& visit) const {
    for (std::uint32_t i = 0; i < count_; ++i) visit(i);
  }
  void divide();
  // Those that a box comes near to: 4 ulps of a place in it and its own rounding are under 2^-9 each.
  CellRect cells_of(const Bounds& box) const {
    constexpr double kAround = 0x1p-7;
    const auto cell = [](double place, int count) {
      return static_cast<int>(std::clamp(place, 0.0, count - 1.0));
    };
    const Vec2 low = (box.low - low_) / side_, high = (box.high - low_) / side_;
    const int left = cell(low.x() - kAround, columns_), bottom = cell(low.y() - kAround, rows_);
    return {left, bottom, cell(high.x() + kAround, columns_) - left + 1,
            cell(high.y() + kAround, rows_) - bottom + 1};
  }

  const Surfaces& walls_;
  const std::size_t count_;  // of walls
  std::vector<std::uint32_t> begin_, listed_;
  int columns_ = 0, rows_ = 0;
  Vec2 low_{0, 0};
  double side_ = 1;  // of a cell
};

}  // namespace flatray
