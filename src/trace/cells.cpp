#include "trace/cells.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>

namespace flatray {
namespace {

constexpr double kLargest = 0x1p900, kLeast = 0x1p-900;
constexpr int kMostAside = 4000;  // cells in a row or column: that of all is exact in a float
constexpr double kRoom = 256;     // units left free between the segments and the ring
constexpr double kFar = 0x1p18;   // times M: of origins whose entry is off by a unit / 256
constexpr std::uint32_t kEmpty = 0x80000000U;
constexpr int kLongestSide = 127;

// Cells a segment: many where all stay in the cache, few where they do not.
double cells_wanted(std::size_t segments) {
  const double each = segments <= 16384 ? 4 : 1;
  return each * static_cast<double>(segments);
}
// Records a segment allowed for before cells are made larger.
constexpr double kMostRecords = 8;

std::int32_t even(double count) {
  return 2 * static_cast<std::int32_t>(std::clamp(std::ceil(count / 2), 1.0, kMostAside / 2.0));
}

// The nearest float to x whose last bit is as asked for: off by an ulp at most.
float with_last_bit(double x, bool set) {
  const auto near = static_cast<float>(x);
  const auto bits = std::bit_cast<std::uint32_t>(near);
  if ((bits % 2 == 1) == set) return near;
  const bool outward = near == 0 || std::fabs(static_cast<double>(near)) < std::fabs(x);
  return std::bit_cast<float>(outward ? bits + 1 : bits - 1);
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
  unit_ = 0x1p-24 * (std::max(columns, rows) / 2 + 1);
  stride_ = columns + 2;
  first_ = (rows / 2 + 1) * stride_ + columns / 2 + 1;
  scale_ = Vec2(columns - 2 * kRoom * unit_, rows - 2 * kRoom * unit_).cwiseQuotient(size_);
}

// Long segments would be in so many cells that these are made larger.
void CellGrid::divide(const Surfaces& walls) {
  double along_x = 0, along_y = 0;  // lengths of all, in sizes of the box
  for (const Segment& segment : walls.segments) {
    along_x += std::fabs(segment.b.x() - segment.a.x()) / size_.x();
    along_y += std::fabs(segment.b.y() - segment.a.y()) / size_.y();
  }
  const std::size_t segments = walls.segments.size();
  const double columns = std::sqrt(cells_wanted(segments) * (size_.x() / size_.y()));
  const double rows = columns * (size_.y() / size_.x());
  const double records = columns * along_x + rows * along_y;
  const double shrink =
      std::min(1.0, (kMostRecords * static_cast<double>(segments) + 64) / records);
  set_cells(even(columns * shrink), even(rows * shrink));
}

Vec2 CellGrid::half() const {
  const double room = 0.5 * kRoom * unit_;
  return {0.5 * columns_ - room, 0.5 * rows_ - room};
}

lanes::Grid CellGrid::view() const {
  lanes::Grid grid{};
  grid.cells = words_.data();
  grid.records = records_.data();
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
  return grid;
}

CellGrid::Ends CellGrid::ends(const Segment& segment) const {
  return {place(segment.a), place(segment.b)};
}

// Row by row: the part of the segment in the row and a margin around it, and a margin beside that.
// A rounding moves the part up or down by 2^-50 cells, the margin is 128 units and the walk needs
// 84.
template <class Visit>
void CellGrid::visit_cells(const Segment& segment, const Visit& visit) const {
  const Vec2 corner(0.5 * columns_ + 1, 0.5 * rows_ + 1);
  Vec2 a = place(segment.a) + corner, b = place(segment.b) + corner;
  if (a.y() > b.y()) std::swap(a, b);
  const double margin = lanes::kMargin * unit_, rise = b.y() - a.y(), run = b.x() - a.x();
  const auto row_of = [&](double y) {
    return static_cast<std::int32_t>(std::clamp(y, 1.0, 1.0 * rows_));
  };
  const auto column_of = [&](double x) {
    return static_cast<std::int32_t>(std::clamp(x, 1.0, 1.0 * columns_));
  };
  const auto x_at = [&](double y) {
    return rise > 0 ? a.x() + std::clamp((y - a.y()) / rise, 0.0, 1.0) * run : a.x();
  };
  const auto last = row_of(b.y() + margin);
  for (auto row = row_of(a.y() - margin); row <= last; ++row) {
    double low = rise > 0 ? x_at(row - margin) : a.x();
    double high = rise > 0 ? x_at(row + 1 + margin) : b.x();
    if (low > high) std::swap(low, high);
    const auto end = column_of(high + margin);
    const std::size_t first = static_cast<std::size_t>(row) * static_cast<std::size_t>(stride_);
    for (auto column = column_of(low - margin); column <= end; ++column)
      visit(first + static_cast<std::size_t>(column));
  }
}

bool CellGrid::last(std::size_t record) const {
  return (std::bit_cast<std::uint32_t>(records_[4 * record + 3]) & 1U) != 0;
}

CellGrid::Mark CellGrid::mark(const Segment& segment) const {
  const auto [a, b] = ends(segment);
  return {static_cast<float>(a.x()), static_cast<float>(a.y()), static_cast<float>(b.x())};
}

// Counts, then where each cell begins, then where the next one does; at last the words.
void CellGrid::fill(const Surfaces& walls) {
  words_.assign(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(rows_ + 2), 0);
  const auto each_cell = [&](const auto& visit) {
    for (std::uint32_t slot = 0; slot < walls.segments.size(); ++slot)
      visit_cells(walls.segments[slot], [&](std::size_t cell) { visit(words_[cell], slot); });
  };
  each_cell([](std::uint32_t& count, std::uint32_t) { ++count; });
  std::uint32_t records = 0;
  for (std::uint32_t& word : words_) {
    const std::uint32_t count = word;
    word = count == 0 ? kEmpty : records;
    records += count;
  }
  slots_.resize(records);
  each_cell([&](std::uint32_t& next, std::uint32_t slot) { slots_[next++] = slot; });
  records_.resize(4 * static_cast<std::size_t>(records));
  std::uint32_t begin = 0;
  for (std::uint32_t& word : words_) {
    if (word == kEmpty) continue;
    for (std::uint32_t record = begin; record < word; ++record)
      write_record(ends(walls.segments[slots_[record]]), record + 1 == word, record);
    std::swap(word, begin);
  }
}

void CellGrid::write_record(const Ends& e, bool is_last, std::size_t record) {
  const float row[] = {static_cast<float>(e.a.x()), static_cast<float>(e.a.y()),
                       static_cast<float>(e.b.x()), with_last_bit(e.b.y(), is_last)};
  std::copy_n(row, 4, &records_[4 * record]);
}

// The square that grows from an empty cell is one larger than the least that grow from its three
// neighbours that way.
void CellGrid::mark_empty() {
  const auto stride = static_cast<std::ptrdiff_t>(stride_);
  for (int quadrant = 0; quadrant < 4; ++quadrant) {
    const bool left = quadrant % 2 == 1, down = quadrant / 2 == 1;
    const std::ptrdiff_t dx = left ? -1 : 1, dy = down ? -stride : stride;
    const int shift = 7 * quadrant;
    const auto side = [&](std::ptrdiff_t cell) -> std::uint32_t {
      const std::uint32_t word = words_[static_cast<std::size_t>(cell)];
      return (word & kEmpty) != 0 ? word >> shift & 127U : 0;
    };
    for (std::ptrdiff_t i = 1; i <= rows_; ++i) {
      const std::ptrdiff_t row = (down ? i : rows_ + 1 - i) * stride;
      for (std::ptrdiff_t k = 1; k <= columns_; ++k) {
        const std::ptrdiff_t cell = row + (left ? k : columns_ + 1 - k);
        std::uint32_t& word = words_[static_cast<std::size_t>(cell)];
        if ((word & kEmpty) == 0) continue;
        const std::uint32_t least =
            std::min({side(cell + dx), side(cell + dy), side(cell + dx + dy)});
        word |= std::min<std::uint32_t>(least + 1, kLongestSide) << shift;
      }
    }
  }
}

// By a table of hashes: that two marks share one is as good as that they are equal.
void CellGrid::find_twins(const Surfaces& walls) {
  const std::size_t room = std::bit_ceil(2 * walls.segments.size());
  struct Entry {
    std::uint64_t hash = 0;
    std::uint32_t slot = 0;
  };
  std::vector<Entry> table(room);
  for (std::uint32_t slot = 0; slot < walls.segments.size(); ++slot) {
    const Mark m = mark(walls.segments[slot]);
    // + 0: -0 and 0 are equal to the kernels.
    const auto word = [](float x) -> std::uint64_t { return std::bit_cast<std::uint32_t>(x + 0); };
    std::uint64_t hash = (word(m.ax) << 32 | word(m.ay)) * 0x9e3779b97f4a7c15U;
    hash = ((hash ^ hash >> 29) + word(m.bx)) * 0xbf58476d1ce4e5b9U | 1;
    std::size_t at = hash >> 20 & (room - 1);
    while (table[at].hash != 0 && table[at].hash != hash) at = (at + 1) & (room - 1);
    if (table[at].hash == hash) {
      twins_.resize(walls.segments.size());
      twins_[slot] = twins_[table[at].slot] = true;
    } else {
      table[at] = {hash, slot};
    }
  }
}

std::optional<CellGrid> CellGrid::build(const Surfaces& walls) {
  CellGrid grid;
  if (!grid.measure(walls)) return std::nullopt;
  grid.divide(walls);
  grid.fill(walls);
  grid.mark_empty();
  grid.find_twins(walls);
  return grid;
}

std::optional<CellGrid> CellGrid::build_list(const Surfaces& walls) {
  CellGrid grid;
  if (!grid.measure(walls)) return std::nullopt;
  grid.set_cells(2, 2);
  const std::size_t count = walls.segments.size();
  grid.slots_.resize(count);
  std::iota(grid.slots_.begin(), grid.slots_.end(), 0U);
  grid.records_.resize(4 * count);
  for (std::size_t i = 0; i < count; ++i)
    grid.write_record(grid.ends(walls.segments[i]), i + 1 == count, i);
  grid.find_twins(walls);
  return grid;
}

std::size_t CellGrid::bytes() const {
  return 4 * (words_.size() + slots_.size() + records_.size()) + twins_.size() / 8;
}

}  // namespace flatray
