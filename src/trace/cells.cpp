#include "trace/cells.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace flatray {
namespace {

constexpr double kLargest = 0x1p900, kLeast = 0x1p-900;
constexpr int kMostAside = 4000;  // cells in a row or column: that of all is exact in a float
constexpr double kRoom = 256;     // units left free between the segments and the ring
constexpr double kFar = 0x1p18;   // times M: of origins whose entry is off by a unit / 256

// Records a segment allowed for before cells are made larger.
constexpr double kMostRecords = 8;
constexpr double kMostCells = 4;                // a segment: more did not pay anywhere
constexpr std::size_t kCached = 16384;          // segments up to which all stays in the cache
constexpr std::size_t kSecondCache = 1U << 20;  // bytes

// Cells a segment, of segments that each are in 1 + crossings * sqrt(cells) cells: beyond the cache
// as many as leave words and records 40 bytes a segment, but not below one.
double cells_wanted(std::size_t segments, double crossings) {
  constexpr double kBytes = 40, kRecord = 20, kWord = 4;
  if (segments <= kCached) return kMostCells;
  const double b = kRecord * crossings;
  const double root = (std::sqrt(b * b + 4 * kWord * (kBytes - kRecord)) - b) / (2 * kWord);
  return std::clamp(root * root, 1.0, kMostCells);
}

std::int32_t even(double count) {
  return 2 * static_cast<std::int32_t>(std::clamp(std::ceil(count / 2), 1.0, kMostAside / 2.0));
}

}  // namespace

bool CellGrid::measure(const Surfaces& walls) {
  Bounds box;
  for (const Segment& segment : walls.segments) {
    box.add(segment.a);
    box.add(segment.b);
  }
  if (box.empty() || !(box.low.cwiseAbs().maxCoeff() < kLargest) ||
      !(box.high.cwiseAbs().maxCoeff() < kLargest))
    return false;
  centre_ = box.centre();  // rounded: one side may be farther from it
  size_ = 2 * (box.high - centre_).cwiseMax(centre_ - box.low);
  const double most = size_.maxCoeff();
  size_ = size_.cwiseMax(Vec2(0x1p-20 * most, 0x1p-20 * most));
  return most > kLeast;
}

void CellGrid::set_cells(std::int32_t columns, std::int32_t rows) {
  columns_ = columns;
  rows_ = rows;
  const std::int32_t half_columns = columns / 2, half_rows = rows / 2;
  unit_ = 0x1p-24 * (std::max(half_columns, half_rows) + 1);
  stride_ = columns + 2;
  first_ = (half_rows + 1) * stride_ + half_columns + 1;
  scale_ = Vec2(columns - 2 * kRoom * unit_, rows - 2 * kRoom * unit_).cwiseQuotient(size_);
}

// Long segments would be in so many cells that these are made larger.
void CellGrid::divide(const Surfaces& walls) {
  double along_x = 0, along_y = 0;  // lengths of all, in sizes of the box
  for (std::size_t slot = 0; slot < walls.segments.size(); ++slot) {
    if (is_copy(slot)) continue;
    const Segment& segment = walls.segments[slot];
    along_x += std::fabs(segment.b.x() - segment.a.x()) / size_.x();
    along_y += std::fabs(segment.b.y() - segment.a.y()) / size_.y();
  }
  const auto segments = static_cast<double>(kept_);
  const double aspect = std::sqrt(size_.x() / size_.y());  // columns and rows of one cell each
  const double crossings = (aspect * along_x + along_y / aspect) / std::sqrt(segments);
  const double cells = cells_wanted(kept_, crossings);
  const double columns = std::sqrt(cells * segments) * aspect;
  const double rows = std::sqrt(cells * segments) / aspect;
  const double records = segments * crossings * std::sqrt(cells);
  const double shrink = std::min(1.0, (kMostRecords * segments + 64) / records);
  set_cells(even(columns * shrink), even(rows * shrink));
}

Vec2 CellGrid::half() const {
  const double room = 0.5 * kRoom * unit_;
  return {0.5 * columns_ - room, 0.5 * rows_ - room};
}

lanes::Grid CellGrid::view() const {
  lanes::Grid grid{};
  grid.cells = words_.empty() ? nullptr : words_.data();
  grid.records = records_.data();
  grid.slots = slots_.data();
  grid.centre_x = centre_.x();
  grid.centre_y = centre_.y();
  grid.scale_x = scale_.x();
  grid.scale_y = scale_.y();
  grid.half_x = half().x();
  grid.half_y = half().y();
  grid.ring_x = -0.5 * columns_ - 0.5;
  grid.ring_y = -0.5 * rows_ - 0.5;
  grid.far = kFar * 0x1p24 * unit_;
  grid.stride = static_cast<float>(stride_);
  grid.first = static_cast<float>(first_);
  grid.unit = static_cast<float>(unit_);
  grid.is_large = bytes() > kSecondCache;
  return grid;
}

Segment CellGrid::ends(const Segment& segment) const {
  return {place(segment.a), place(segment.b)};
}

CellGrid::Cell CellGrid::cell_at(const Vec2& place, const Turn& turn) const {
  const Vec2 corner(std::floor(place.x()), std::floor(place.y()));
  const auto index = [](double x, bool turned, double all) { return turned ? all - 1 - x : x; };
  const double x = index(corner.x(), turn.x, 0), y = index(corner.y(), turn.y, 0);
  const std::uint32_t word = words_[static_cast<std::size_t>(first_ + stride_ * y + x)];
  if ((word >> 30) != 1) return {corner, 1, word};
  const auto n = static_cast<double>(std::bit_cast<float>(word & 0x7f800000U));
  const Vec2 part = n * (place - corner);
  // Of a place just below a whole number the difference may round to 1.
  const double column = std::min(std::floor(part.x()), n - 1);
  const double row = std::min(std::floor(part.y()), n - 1);
  const double at = index(row, turn.y, n) * n + index(column, turn.x, n);
  return {corner + Vec2(column, row) / n, 1 / n,
          words_[16 * std::size_t{word & 0x7fffffU} + static_cast<std::size_t>(at)]};
}

bool CellGrid::last(std::size_t record) const {
  return (std::bit_cast<std::uint32_t>(records_[4 * record + 3]) & 1U) != 0;
}

CellGrid::Mark CellGrid::mark(const Segment& segment) const {
  const auto [a, b] = ends(segment);
  return {static_cast<float>(a.x()), static_cast<float>(a.y()), static_cast<float>(b.x())};
}

std::optional<CellGrid> CellGrid::build(const Surfaces& walls, unsigned threads) {
  CellGrid grid;
  if (!grid.measure(walls)) return std::nullopt;
  grid.find_copies(walls, threads);
  grid.divide(walls);
  grid.fill(walls, threads);
  grid.find_twins(walls, threads);
  return grid;
}

std::optional<CellGrid> CellGrid::build_list(const Surfaces& walls) {
  CellGrid grid;
  if (!grid.measure(walls)) return std::nullopt;
  grid.set_cells(2, 2);
  grid.find_copies(walls, 1);
  for (std::uint32_t slot = 0; slot < walls.segments.size(); ++slot)
    if (!grid.is_copy(slot)) grid.slots_.push_back(slot);
  const std::size_t count = grid.slots_.size();
  grid.records_.resize(4 * (count + kBeyond));
  for (std::size_t i = 0; i < count; ++i)
    write_record(grid.ends(walls.segments[grid.slots_[i]]), i + 1 == count, &grid.records_[4 * i]);
  grid.find_twins(walls, 1);
  return grid;
}

std::size_t CellGrid::bytes() const {
  return 4 * (words_.size() + slots_.size() + records_.size() + next_copy_.size()) +
         (twins_.size() + copies_.size()) / 8;
}

}  // namespace flatray
