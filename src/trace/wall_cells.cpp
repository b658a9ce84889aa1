#include "trace/wall_cells.h"

#include <algorithm>
#include <cmath>

#include "base/counted.h"
#include "trace/curve_records.h"

namespace flatray {
namespace {

constexpr std::size_t kFew = 8;  // are looked at without cells
constexpr double kCellsAWall = 2, kMostWallCells = 0x1p22;
// Width and height of a wall in cells, on average: those that lie on one another, all as large as the grid, would pass
// the root of all cells each.
constexpr double kCellsAcross = 10;
constexpr double kMargin = 0x1p-10;  // of a cell's side, by which lists reach beyond it
constexpr double kLeastSize = 0x1p-400, kMostSize = 0x1p400;

}  // namespace

WallCells::WallCells(const Surfaces& walls) : walls_(walls), count_(walls.size()) {
  if (count_ > kFew) divide();
}

// Cells of one size, as many as the walls need, and one more all round.
void WallCells::divide() {
  Bounds box;
  double extents = 0;
  visit_all([&](std::uint32_t i) {
    const Bounds own = walls_.visit(i, [](const auto& wall) { return bounds_of(wall); });
    box.add(own);
    extents += own.size().sum() / static_cast<double>(count_);
  });
  const Vec2 size = box.size();
  const double larger = size.maxCoeff(),
               magnitude = box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs()).maxCoeff();
  if (!(larger > kLeastSize && magnitude < kMostSize)) return;
  const double wanted = std::min(kCellsAWall * static_cast<double>(count_), kMostWallCells);
  const double narrow = std::max(size.minCoeff(), larger / wanted);
  side_ = std::max(std::sqrt(narrow / wanted * larger), larger * 0x1p-20);
  side_ = std::max(side_, extents / kCellsAcross);
  low_ = box.low - Vec2::Constant(side_);
  // Where doubles are as far apart as cells, places in them mean nothing.
  if (!(magnitude * 0x1p-30 < side_ * 0x1p10)) return;
  columns_ = static_cast<int>(size.x() / side_) + 3;
  rows_ = static_cast<int>(size.y() / side_) + 3;
  const auto cells = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  begin_.assign(cells + 1, 0);
  const auto visit_passed = [&](const auto& visit) {
    visit_all([&](std::uint32_t i) {
      walls_.visit(i, [&](const auto& wall) {
        const auto passes = passes_of(wall, low_);
        visit_rect(
            cells_of(bounds_of(wall)),
            [&](const Vec2& middle, const Vec2& half) {
              return passes(side_ * middle, side_ * (half + Vec2(kMargin, kMargin)));
            },
            [&](std::int32_t column, std::int32_t row) {
              visit(i, static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                           static_cast<std::size_t>(column));
            });
      });
    });
  };
  visit_passed([&](std::uint32_t, std::size_t cell) { ++begin_[cell + 1]; });
  for (std::size_t i = 0; i < cells; ++i) begin_[i + 1] += begin_[i];
  listed_.resize(begin_.back());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  visit_passed([&](std::uint32_t i, std::size_t cell) { listed_[next[cell]++] = i; });
}

std::string WallCells::structure() const {
  return counted(count_, "wall") + " in " +
         (begin_.empty() ? "one list"
                         : std::to_string(columns_) + " x " + std::to_string(rows_) + " cells");
}

}  // namespace flatray
