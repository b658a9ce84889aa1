#include "transport/wall_cells.h"

#include <cmath>

namespace flatray {
namespace {

// Fewer walls than this are looked at one by one.
constexpr std::size_t kFewWalls = 16;
constexpr double kMostSide = 2048, kCellsAWall = 4;
constexpr double kLeast = 0x1p-900, kMost = 0x1p900;

}  // namespace

WallCells::WallCells(const Surfaces& walls) : walls_(walls), curves_(walls) {
  if (walls.segments.size() > kFewWalls && divide()) fill();
}

void WallCells::fill() {
  std::vector<std::uint32_t> next(side_ * side_ + 1);
  for (const Segment& wall : walls_.segments)
    for (const std::size_t cell : cells_of(wall)) ++next[cell + 1];
  for (std::size_t cell = 1; cell < next.size(); ++cell) next[cell] += next[cell - 1];
  begin_ = next;
  segments_.resize(next.back());
  for (std::size_t slot = 0; slot < walls_.segments.size(); ++slot)
    for (const std::size_t cell : cells_of(walls_.segments[slot]))
      segments_[next[cell]++] = walls_.segment_numbers[slot];
}

// As many cells as walls, or fewer, so that walls that go through many cells have kCellsAWall on
// average. Whether there is room for them.
bool WallCells::divide() {
  Bounds all;
  for (const Segment& wall : walls_.segments) all.add(bounds_of(wall));
  const double largest = std::max(all.low.cwiseAbs().maxCoeff(), all.high.cwiseAbs().maxCoeff());
  const Vec2 size = all.size();
  if (!(largest < kMost && size.minCoeff() > kLeast)) return false;
  double crossed = 0;  // borders, a cell's side being that of all
  for (const Segment& wall : walls_.segments)
    crossed += bounds_of(wall).size().cwiseQuotient(size).sum();
  const auto count = static_cast<double>(walls_.segments.size());
  side_ = static_cast<std::size_t>(
              std::min({kMostSide, std::sqrt(count), kCellsAWall * count / crossed})) +
          1;
  low_ = all.low;
  scale_ = static_cast<double>(side_) * size.cwiseInverse();
  slack_ = 0x1p-48 * largest;
  return true;
}

std::string WallCells::structure() const {
  const std::string curves = curves_.structure();
  if (walls_.segments.empty() && !curves.empty()) return curves;
  const std::string side = std::to_string(side_);
  const std::string segments = side_ == 0 ? "one list" : side + " x " + side + " cells";
  return curves.empty() ? segments : segments + ", " + curves;
}

// In parts about as long as a cell, so that a slanted wall is not in all cells of its box.
std::vector<std::size_t> WallCells::cells_of(const Segment& wall) const {
  const Bounds box = bounds_of(wall);
  const auto columns = [&](int axis) {
    return column(axis, box.high[axis]) - column(axis, box.low[axis]);
  };
  const std::size_t parts = std::min(columns(0), columns(1)) + 1;
  std::vector<std::size_t> met;
  const Vec2 way = wall.b - wall.a, slack = Vec2::Constant(parts == 1 ? 0 : slack_);
  const auto at = [&](std::size_t k) {
    if (k == 0 || k == parts) return k == 0 ? wall.a : wall.b;
    return Vec2(wall.a + static_cast<double>(k) / static_cast<double>(parts) * way);
  };
  for (std::size_t i = 0; i < parts; ++i) {
    const Bounds part = bounds_of(Segment{at(i), at(i + 1)});
    visit_cells({part.low - slack, part.high + slack},
                [&](std::size_t cell) { met.push_back(cell); });
  }
  std::sort(met.begin(), met.end());
  met.erase(std::unique(met.begin(), met.end()), met.end());
  return met;
}

}  // namespace flatray
