// Filling the cells of a grid.
#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "trace/cells.h"

namespace flatray {
namespace {

constexpr std::uint32_t kEmpty = 0x80000000U;
constexpr std::uint32_t kLongestSide = 127;
constexpr std::size_t kCrowded = 16;  // segments of a cell that is divided
constexpr int kMostParts = 64;        // of its sides

// The nearest float to x whose last bit is as asked for: off by an ulp at most.
float with_last_bit(double x, bool set) {
  const auto near = static_cast<float>(x);
  const auto bits = std::bit_cast<std::uint32_t>(near);
  if ((bits % 2 == 1) == set) return near;
  const bool outward = near == 0 || std::fabs(static_cast<double>(near)) < std::fabs(x);
  return std::bit_cast<float>(outward ? bits + 1 : bits - 1);
}

// A rectangle of cells, the lower left corner of the first being (0, 0).
struct Raster {
  std::int32_t columns, rows;
  double margin;  // in cells
};

// Cells that a segment comes near to. Row by row: the part of the segment in the row and a margin
// around it, and a margin beside that. A rounding moves the part up or down by 2^-50 cells, the
// margin is 128 units and the walk needs 84.
template <class Visit>
void visit_cells(const Raster& raster, Vec2 a, Vec2 b, const Visit& visit) {
  if (a.y() > b.y()) std::swap(a, b);
  const double rise = b.y() - a.y(), run = b.x() - a.x();
  const auto cell_of = [](double x) {
    return static_cast<std::int32_t>(std::floor(std::clamp(x, -1.0, 1e6)));
  };
  const auto x_at = [&](double y) {
    return rise > 0 ? a.x() + std::clamp((y - a.y()) / rise, 0.0, 1.0) * run : a.x();
  };
  const std::int32_t last = std::min(cell_of(b.y() + raster.margin), raster.rows - 1);
  for (auto row = std::max(cell_of(a.y() - raster.margin), 0); row <= last; ++row) {
    double low = rise > 0 ? x_at(row - raster.margin) : a.x();
    double high = rise > 0 ? x_at(row + 1 + raster.margin) : b.x();
    if (low > high) std::swap(low, high);
    const std::int32_t end = std::min(cell_of(high + raster.margin), raster.columns - 1);
    for (auto column = std::max(cell_of(low - raster.margin), 0); column <= end; ++column)
      visit(column, row);
  }
}

// The square that grows from an empty cell is one larger than the least that grow from its three
// neighbours that way; beyond the raster none grows.
void mark_empty(std::uint32_t* words, std::ptrdiff_t stride, const Raster& raster) {
  for (int quadrant = 0; quadrant < 4; ++quadrant) {
    const bool left = quadrant % 2 == 1, down = quadrant / 2 == 1;
    const int shift = 7 * quadrant;
    for (std::int32_t i = 0; i < raster.rows; ++i) {
      const std::int32_t row = down ? i : raster.rows - 1 - i;
      for (std::int32_t k = 0; k < raster.columns; ++k) {
        const std::int32_t column = left ? k : raster.columns - 1 - k;
        std::uint32_t* word = words + row * stride + column;
        if ((*word & kEmpty) == 0) continue;
        std::uint32_t least = 0;
        if (i > 0 && k > 0) {
          const std::ptrdiff_t dx = left ? -1 : 1, dy = down ? -stride : stride;
          const auto side = [&](std::ptrdiff_t to) {
            return (word[to] & kEmpty) != 0 ? word[to] >> shift & kLongestSide : 0;
          };
          least = std::min({side(dx), side(dy), side(dx + dy)});
        }
        *word |= std::min(least + 1, kLongestSide) << shift;
      }
    }
  }
}

// Slots by cell.
struct Lists {
  std::vector<std::uint32_t> ends, slots;

  template <class EachCell>
  void fill(std::size_t cells, const EachCell& each_cell) {
    ends.assign(cells, 0);
    each_cell([&](std::size_t cell, std::uint32_t) { ++ends[cell]; });
    std::uint32_t sum = 0;
    for (std::uint32_t& end : ends) sum += std::exchange(end, sum);
    slots.resize(sum);
    each_cell([&](std::size_t cell, std::uint32_t slot) { slots[ends[cell]++] = slot; });
  }
  std::span<const std::uint32_t> of(std::size_t cell) const {
    const std::uint32_t begin = cell == 0 ? 0 : ends[cell - 1];
    return {slots.data() + begin, ends[cell] - begin};
  }
};

}  // namespace

// The word of a cell with these segments, whose records come next.
std::uint32_t CellGrid::write_list(const Surfaces& walls, std::span<const std::uint32_t> slots) {
  if (slots.empty()) return kEmpty;
  const std::size_t first = slots_.size();
  slots_.insert(slots_.end(), slots.begin(), slots.end());
  records_.resize(4 * slots_.size());
  for (std::size_t i = 0; i < slots.size(); ++i)
    write_record(ends(walls.segments[slots[i]]), i + 1 == slots.size(), first + i);
  return static_cast<std::uint32_t>(first);
}

// Into how many parts the sides of a crowded cell are cut: about as many cells as segments, fewer
// where these would be in more than four of them each, or cells not be much wider than the margin.
int CellGrid::parts(const Surfaces& walls, std::span<const std::uint32_t> slots) const {
  if (slots.size() < kCrowded) return 1;
  const auto count = static_cast<double>(slots.size());
  double length = 0;
  for (const std::uint32_t slot : slots) {
    const auto [a, b] = ends(walls.segments[slot]);
    length += std::min((b - a).cwiseAbs().sum(), 1.5);
  }
  int n = 1;
  while (n < kMostParts && n * n < count && n * length < 2 * count &&
         lanes::kMargin * unit_ * n < 0x1p-4)
    n *= 2;
  return n;
}

std::uint32_t CellGrid::write_divided(const Surfaces& walls, std::span<const std::uint32_t> slots,
                                      const Vec2& corner, int n) {
  const std::size_t base = words_.size();
  const auto cells = static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
  words_.resize(base + (cells + 15) / 16 * 16);
  const Raster raster{n, n, lanes::kMargin * unit_ * n};
  Lists lists;
  lists.fill(cells, [&](const auto& visit) {
    for (const std::uint32_t slot : slots) {
      const auto [a, b] = ends(walls.segments[slot]);
      visit_cells(raster, n * (a - corner), n * (b - corner),
                  [&](std::int32_t column, std::int32_t row) {
                    visit(static_cast<std::size_t>(row * n + column), slot);
                  });
    }
  });
  for (std::size_t cell = 0; cell < cells; ++cell)
    words_[base + cell] = write_list(walls, lists.of(cell));
  mark_empty(&words_[base], n, raster);
  return std::bit_cast<std::uint32_t>(static_cast<float>(n)) |
         static_cast<std::uint32_t>(base / 16);
}

void CellGrid::fill(const Surfaces& walls) {
  const auto stride = static_cast<std::size_t>(stride_);
  const std::size_t cells = stride * static_cast<std::size_t>(rows_ + 2);
  const Raster raster{columns_, rows_, lanes::kMargin * unit_};
  const Vec2 corner(0.5 * columns_, 0.5 * rows_);
  const auto index = [&](std::int32_t column, std::int32_t row) {
    return static_cast<std::size_t>(row + 1) * stride + static_cast<std::size_t>(column + 1);
  };
  Lists lists;
  lists.fill(cells, [&](const auto& visit) {
    for (std::uint32_t slot = 0; slot < walls.segments.size(); ++slot) {
      const auto [a, b] = ends(walls.segments[slot]);
      visit_cells(raster, a + corner, b + corner,
                  [&](std::int32_t column, std::int32_t row) { visit(index(column, row), slot); });
    }
  });
  slots_.reserve(lists.slots.size());
  records_.reserve(4 * (lists.slots.size() + kBeyond));
  words_.assign((cells + 15) / 16 * 16, kEmpty);
  for (std::int32_t row = 0; row < rows_; ++row)
    for (std::int32_t column = 0; column < columns_; ++column) {
      const std::size_t cell = index(column, row);
      const auto slots = lists.of(cell);
      const int n = parts(walls, slots);
      words_[cell] = n == 1 ? write_list(walls, slots)
                            : write_divided(walls, slots, Vec2(column, row) - corner, n);
      divided_ += n > 1 ? 1 : 0;
    }
  mark_empty(&words_[index(0, 0)], static_cast<std::ptrdiff_t>(stride), raster);
  records_.resize(4 * (slots_.size() + kBeyond));
}

void CellGrid::write_record(const Ends& e, bool is_last, std::size_t record) {
  const float row[] = {static_cast<float>(e.a.x()), static_cast<float>(e.a.y()),
                       static_cast<float>(e.b.x()), with_last_bit(e.b.y(), is_last)};
  std::copy_n(row, 4, &records_[4 * record]);
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

}  // namespace flatray
