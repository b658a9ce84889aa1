#include "trace/cells.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "trace/curve_records.h"

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
constexpr std::size_t kFewCurves = 16;          // that are in one list
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
  for (std::size_t slot = 0; slot < slots(walls); ++slot)
    if (of_curves_)
      box.add(
          walls.visit(walls.curve_numbers[slot], [](const auto& wall) { return bounds_of(wall); }));
    else
      box.add(bounds_of(walls.segments[slot]));
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
  if (of_curves_) scale_.setConstant(scale_.minCoeff());  // so that circles are circles
}

// Of a segment, or twice that of a curve, which most often goes there and back.
Vec2 CellGrid::extent_of(const Surfaces& walls, std::size_t slot) const {
  if (!of_curves_) return (walls.segments[slot].b - walls.segments[slot].a).cwiseAbs();
  return walls.visit(walls.curve_numbers[slot],
                     [](const auto& wall) -> Vec2 { return 2 * bounds_of(wall).size(); });
}

// Long segments would be in so many cells that these are made larger.
void CellGrid::divide(const Surfaces& walls) {
  double along_x = 0, along_y = 0;  // lengths of all, in sizes of the box
  for (std::size_t slot = 0; slot < slots(walls); ++slot) {
    if (is_copy(slot)) continue;
    const Vec2 extent = extent_of(walls, slot);
    along_x += extent.x() / size_.x();
    along_y += extent.y() / size_.y();
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
  grid.curves = of_curves_ ? curves_.data() : nullptr;
  grid.ends = circles_.data();
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

Segment CellGrid::placed(const Segment& segment) const {
  return {place(segment.a), place(segment.b)};
}
Bezier CellGrid::placed(const Bezier& wall) const {
  Bezier placed = wall;
  for (Vec2& point : placed.points) point = place(point);
  return placed;
}
// Of half a curve `from` is no point, but what it lies towards; that cells keep, as they are square for curves.
Arc CellGrid::placed(const Arc& wall) const {
  const auto& [centre, u, v] = wall.curve;
  const bool is_half = wall.extent == Arc::Extent::half;
  return {{place(centre), u.cwiseProduct(scale_), v.cwiseProduct(scale_)},
          wall.extent,
          is_half ? wall.from : place(wall.from),
          place(wall.to)};
}

bool CellGrid::last(std::size_t record) const {
  return (std::bit_cast<std::uint32_t>(records_[4 * record + 3]) & 1U) != 0;
}

CellGrid::Mark CellGrid::mark(const Segment& segment) const {
  const auto [a, b] = placed(segment);
  return {static_cast<float>(a.x()), static_cast<float>(a.y()), static_cast<float>(b.x())};
}

std::optional<CellGrid> CellGrid::build(const Surfaces& walls, unsigned threads) {
  return build(walls, false, true, threads);
}
std::optional<CellGrid> CellGrid::build_list(const Surfaces& walls) {
  return build(walls, false, false, 1);
}
std::optional<CellGrid> CellGrid::build_of_curves(const Surfaces& walls, unsigned threads) {
  return build(walls, true, walls.curve_numbers.size() > kFewCurves, threads);
}

std::optional<CellGrid> CellGrid::build(const Surfaces& walls, bool of_curves, bool in_cells,
                                        unsigned threads) {
  CellGrid grid;
  grid.of_curves_ = of_curves;
  if (!grid.measure(walls)) return std::nullopt;
  grid.kept_ = grid.slots(walls);
  if (!of_curves) grid.find_copies(walls, threads);
  if (in_cells)
    grid.divide(walls);
  else
    grid.set_cells(2, 2);
  if (of_curves) grid.find_forms(walls);
  if (in_cells)
    grid.fill(walls, threads);
  else
    grid.fill_list(walls);
  if (!of_curves) grid.find_twins(walls, threads);
  return grid;
}

void CellGrid::find_forms(const Surfaces& walls) {
  const double reach = 0x1p24 * unit_;
  for (const std::uint32_t surface : walls.curve_numbers) {
    const std::optional<Circle> circle =
        walls.visit(surface, [](const auto& wall) { return circle_along(wall); });
    const Vec2 centre = circle ? circle->centre : Vec2(0, 0);
    const double radius = circle ? circle->radius : 0;
    circles_.insert(circles_.end(), {centre.x(), centre.y(), radius, 0});
    discs_.push_back(walls.visit(surface, [](const auto& wall) { return disc_about(wall); }));
    magnitude_ =
        std::max(magnitude_, discs_.back().centre.cwiseAbs().maxCoeff() + discs_.back().radius);
    const Arc* arc = walls.arc_at(surface);
    curves_.push_back(arc == nullptr ? doubtful_curve() : curve_form_in_lanes(placed(*arc), reach));
    sure_curves_ += curves_.back().doubt == 0 ? 1 : 0;
  }
}

std::size_t CellGrid::bytes() const {
  return 4 * (words_.size() + slots_.size() + records_.size() + next_copy_.size()) +
         sizeof(lanes::Curve) * curves_.size() + 8 * circles_.size() +
         sizeof(BoundingDisc) * discs_.size() + (twins_.size() + copies_.size()) / 8;
}

}  // namespace flatray
