// Filling the cells of a grid: rows in strips, each on its own, whose lists are then put one after
// the other.
#include <array>
#include <bit>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "base/parallel.h"
#include "trace/cell_raster.h"
#include "trace/cells.h"
#include "trace/curve_records.h"

namespace flatray {
namespace {

constexpr std::size_t kCrowded = 16;  // segments of a cell that is divided
constexpr int kMostParts = 64;        // of its sides
// Of all crowded cells together, whose words find theirs among 2^27; beyond, which takes eight million
// walls and more, no cell is divided.
constexpr std::size_t kMostDividedWords = (std::size_t{1} << 27) - (std::size_t{1} << 25);
constexpr std::size_t kSegmentsAStrip = 4096;  // fewer would not pay for a task
constexpr std::size_t kMostStrips = 64;
constexpr std::size_t kSegmentsAChunk = 32768;  // sorted into strips by one task

// The nearest float to x whose last bit is as asked for: off by an ulp at most.
float with_last_bit(double x, bool set) {
  const auto near = static_cast<float>(x);
  const auto bits = std::bit_cast<std::uint32_t>(near);
  if ((bits % 2 == 1) == set) return near;
  const bool outward = near == 0 || std::fabs(static_cast<double>(near)) < std::fabs(x);
  return std::bit_cast<float>(outward ? bits + 1 : bits - 1);
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

// Segments by the strip of rows they come near to: of each chunk of them, so that they stay in
// order.
class Strips {
 public:
  Strips(const Raster& raster, std::size_t segments)
      : rows_(raster.rows),
        count_(std::clamp<std::size_t>(
            segments / kSegmentsAStrip, 1,
            std::min<std::size_t>(kMostStrips, static_cast<std::size_t>(raster.rows)))),
        segments_(static_cast<std::uint32_t>(segments)),
        lists_(count_ == 1 ? 0 : (segments + kSegmentsAChunk - 1) / kSegmentsAChunk) {}

  std::size_t size() const { return count_; }
  RowRange rows(std::size_t strip) const { return {first_row(strip), first_row(strip + 1) - 1}; }

  /// `rows_of(slot)` is where a segment lies.
  template <class RowsOf>
  void sort(unsigned threads, const RowsOf& rows_of) {
    parallel_for(lists_.size(), threads, [&](std::size_t chunk) {
      lists_[chunk].resize(count_);
      const std::size_t end = std::min<std::size_t>(segments_, (chunk + 1) * kSegmentsAChunk);
      for (std::size_t slot = chunk * kSegmentsAChunk; slot < end; ++slot) {
        const RowRange near = rows_of(slot);
        for (std::size_t strip = strip_of(near.first); strip < count_; ++strip) {
          if (first_row(strip) > near.last) break;
          lists_[chunk][strip].push_back(static_cast<std::uint32_t>(slot));
        }
      }
    });
  }
  template <class Visit>
  void visit(std::size_t strip, const Visit& visit) const {
    for (std::uint32_t slot = 0; count_ == 1 && slot < segments_; ++slot) visit(slot);
    for (const auto& chunk : lists_)
      for (const std::uint32_t slot : chunk[strip]) visit(slot);
  }

 private:
  std::int32_t first_row(std::size_t strip) const {
    return static_cast<std::int32_t>(strip * static_cast<std::size_t>(rows_) / count_);
  }
  std::size_t strip_of(std::int32_t row) const {
    std::size_t strip = static_cast<std::size_t>(row) * count_ / static_cast<std::size_t>(rows_);
    while (strip + 1 < count_ && first_row(strip + 1) <= row) ++strip;
    return strip;
  }

  std::int32_t rows_;
  std::size_t count_;
  std::uint32_t segments_;
  std::vector<std::vector<std::vector<std::uint32_t>>>
      lists_;  // by chunk and strip; none for one strip
};

// Cells of a raster that a wall comes near to.
template <class Visit>
void visit_wall_cells(const Raster& raster, const RowRange& rows, const Frame& frame,
                      const Segment& wall, const Visit& visit) {
  visit_cells(raster, rows, frame.parts * (wall.a - frame.corner),
              frame.parts * (wall.b - frame.corner), visit);
}
template <class Curve, class Visit>
void visit_wall_cells(const Raster& raster, const RowRange& rows, const Frame& frame,
                      const Curve& wall, const Visit& visit) {
  const Bounds box = bounds_of(wall);
  const Vec2 low = frame.parts * (box.low - frame.corner);
  const Vec2 high = frame.parts * (box.high - frame.corner);
  const RowRange near = rows_near(raster, low, high);
  const std::int32_t left = std::max(cell_of(low.x() - raster.margin), 0);
  const std::int32_t right = std::min(cell_of(high.x() + raster.margin), raster.columns - 1);
  const std::int32_t bottom = std::max(near.first, rows.first);
  const std::int32_t top = std::min(near.last, rows.last);
  const auto passes = passes_of(wall, frame.corner);
  const Vec2 margin = Vec2::Constant(raster.margin);
  visit_rect(
      {left, bottom, right - left + 1, top - bottom + 1},
      [&](const Vec2& middle, const Vec2& half) {
        return passes(middle / frame.parts, (half + margin) / frame.parts);
      },
      visit);
}

std::array<float, 4> record_of(const Segment& wall, std::size_t, bool is_last, double) {
  return {static_cast<float>(wall.a.x()), static_cast<float>(wall.a.y()),
          static_cast<float>(wall.b.x()), with_last_bit(wall.b.y(), is_last)};
}
bool is_whole_circle(const Arc& wall, const BoundingDisc& disc) {
  return wall.extent == Arc::Extent::whole && wall.curve.is_circle() &&
         disc.centre == wall.curve.centre && disc.radius == wall.curve.u.x();
}
bool is_whole_circle(const Bezier&, const BoundingDisc&) { return false; }
// The smaller of two discs about a curve whose centre is within `reach`.
template <class Curve>
std::array<float, 4> record_of(const Curve& wall, std::size_t slot, bool is_last, double reach) {
  BoundingDisc disc = disc_about(wall);
  const BoundingDisc of_box = disc_about_box(wall);
  if (disc.centre.cwiseAbs().maxCoeff() > reach || of_box.radius < disc.radius) disc = of_box;
  const auto word = static_cast<std::uint32_t>(4 * slot + (is_whole_circle(wall, disc) ? 2 : 0) +
                                               (is_last ? 1 : 0));
  return {static_cast<float>(disc.centre.x()), static_cast<float>(disc.centre.y()),
          static_cast<float>(disc.radius * (1 + 0x1p-22)), std::bit_cast<float>(word)};
}

}  // namespace

template <class Visit>
void CellGrid::visit_near(const Surfaces& walls, std::size_t slot, const Raster& raster,
                          const RowRange& rows, const Frame& frame, const Visit& each) const {
  visit(walls, slot, [&](const auto& wall) { visit_wall_cells(raster, rows, frame, wall, each); });
}

// The cells of a strip of rows. Its words count records, and words of divided cells, from its own
// first.
class CellGrid::Part {
 public:
  Part(const CellGrid& grid, const Surfaces& walls, int most_parts)
      : grid_(grid), walls_(walls), most_parts_(most_parts) {}

  /// `each_slot(visit)` gives the segments near the rows, by number.
  template <class EachSlot>
  void fill(const Raster& raster, const RowRange& rows, const EachSlot& each_slot) {
    const Vec2 corner(0.5 * raster.columns, 0.5 * raster.rows);
    const auto columns = static_cast<std::size_t>(raster.columns);
    const std::size_t cells = columns * static_cast<std::size_t>(rows.last - rows.first + 1);
    Lists lists;
    lists.fill(cells, [&](const auto& visit) {
      each_slot([&](std::uint32_t slot) {
        if (grid_.is_copy(slot)) return;
        grid_.visit_near(walls_, slot, raster, rows, {-corner, 1},
                         [&](std::int32_t column, std::int32_t row) {
                           visit(static_cast<std::size_t>(row - rows.first) * columns +
                                     static_cast<std::size_t>(column),
                                 slot);
                         });
      });
    });
    slots.reserve(lists.slots.size());
    records.reserve(4 * lists.slots.size());
    words.reserve(cells);
    for (std::size_t cell = 0; cell < cells; ++cell) {
      const std::size_t column = cell % columns, row = cell / columns;
      const Vec2 at(static_cast<double>(column), rows.first + static_cast<double>(row));
      words.push_back(write_cell(lists.of(cell), at - corner));
    }
  }

  /// A word of the part as one of the whole, whose records and divided words begin there.
  static std::uint32_t moved(std::uint32_t word, std::size_t first_record, std::size_t first_word) {
    if ((word & kEmptyCell) != 0) return word;
    return word + static_cast<std::uint32_t>((word >> 30) == 1 ? first_word / 16 : first_record);
  }

  std::vector<std::uint32_t> words, divided_words, slots;
  std::vector<float> records;
  std::size_t divided = 0;

 private:
  std::uint32_t write_cell(std::span<const std::uint32_t> list, const Vec2& corner) {
    const int n = parts(list);
    if (n == 1) return write_list(list);
    ++divided;
    return write_divided(list, corner, n);
  }

  // The word of a cell with these segments, whose records come next.
  std::uint32_t write_list(std::span<const std::uint32_t> list) {
    if (list.empty()) return kEmptyCell;
    const std::size_t first = slots.size();
    slots.insert(slots.end(), list.begin(), list.end());
    records.resize(4 * slots.size());
    for (std::size_t i = 0; i < list.size(); ++i)
      grid_.write_record(walls_, list[i], i + 1 == list.size(), &records[4 * (first + i)]);
    return static_cast<std::uint32_t>(first);
  }

  // Into how many parts the sides of a crowded cell are cut: about as many cells as segments,
  // fewer where these would be in more than four of them each, or cells not be much wider than the
  // margin.
  int parts(std::span<const std::uint32_t> list) const {
    if (list.size() < kCrowded) return 1;
    const auto count = static_cast<double>(list.size());
    double length = 0;
    for (const std::uint32_t slot : list) {
      const Vec2 extent = grid_.extent_of(walls_, slot).cwiseProduct(grid_.scale_);
      length += std::min(extent.sum(), 1.5);
    }
    int n = 1;
    while (n < most_parts_ && n * n < count && n * length < 2 * count &&
           lanes::kMargin * grid_.unit_ * n < 0x1p-4)
      n *= 2;
    return n;
  }

  std::uint32_t write_divided(std::span<const std::uint32_t> list, const Vec2& corner, int n) {
    const std::size_t base = divided_words.size();
    const auto cells = static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
    divided_words.resize(base + (cells + 15) / 16 * 16, kEmptyCell);
    const Raster raster{n, n, lanes::kMargin * grid_.unit_ * n};
    Lists lists;
    lists.fill(cells, [&](const auto& visit) {
      for (const std::uint32_t slot : list)
        grid_.visit_near(walls_, slot, raster, {0, n - 1}, {corner, static_cast<double>(n)},
                         [&](std::int32_t column, std::int32_t row) {
                           const std::int32_t cell = row * n + column;
                           visit(static_cast<std::size_t>(cell), slot);
                         });
    });
    for (std::size_t cell = 0; cell < cells; ++cell)
      divided_words[base + cell] = write_list(lists.of(cell));
    mark_empty(&divided_words[base], static_cast<std::size_t>(n), raster, 1);
    return std::bit_cast<std::uint32_t>(static_cast<float>(n)) |
           static_cast<std::uint32_t>(base / 16);
  }

  const CellGrid& grid_;
  const Surfaces& walls_;
  const int most_parts_;
};

void CellGrid::fill(const Surfaces& walls, unsigned threads) {
  const Raster raster{columns_, rows_, lanes::kMargin * unit_};
  const Vec2 corner(0.5 * columns_, 0.5 * rows_);
  Strips strips(raster, slots(walls));
  strips.sort(threads, [&](std::size_t slot) {
    return visit(walls, slot, [&](const auto& wall) {
      const Bounds box = bounds_of(wall);
      return rows_near(raster, box.low + corner, box.high + corner);
    });
  });
  std::vector<Part> made;
  const auto make = [&](int most_parts) {
    made.clear();
    for (std::size_t i = 0; i < strips.size(); ++i) made.emplace_back(*this, walls, most_parts);
    parallel_for(strips.size(), threads, [&](std::size_t i) {
      made[i].fill(raster, strips.rows(i), [&](const auto& visit) { strips.visit(i, visit); });
    });
  };
  make(kMostParts);
  std::size_t divided_words = 0;
  for (const Part& part : made) divided_words += part.divided_words.size();
  if (divided_words > kMostDividedWords) make(1);
  std::vector<RowRange> rows;
  for (std::size_t i = 0; i < made.size(); ++i) rows.push_back(strips.rows(i));
  join(made, rows, threads);
  const auto stride = static_cast<std::size_t>(stride_);
  mark_empty(&words_[stride + 1], stride, raster, threads);
}

void CellGrid::join(std::span<const Part> parts, std::span<const RowRange> rows, unsigned threads) {
  const auto stride = static_cast<std::size_t>(stride_);
  const std::size_t cells = (stride * static_cast<std::size_t>(rows_ + 2) + 15) / 16 * 16;
  std::vector<std::size_t> first_record{0}, first_word{cells};
  for (const Part& part : parts) {
    first_record.push_back(first_record.back() + part.slots.size());
    first_word.push_back(first_word.back() + part.divided_words.size());
    divided_ += part.divided;
  }
  words_.assign(first_word.back(), kEmptyCell);
  FLATRAY_CHECK(first_record.back() < std::size_t{1} << 30);  // words of cells hold 30 bits
  slots_.resize(first_record.back());
  records_.resize(4 * (first_record.back() + kBeyond));
  parallel_for(parts.size(), threads, [&](std::size_t i) {
    const Part& part = parts[i];
    const auto whole = [&](std::uint32_t word) {
      return Part::moved(word, first_record[i], first_word[i]);
    };
    auto from = part.words.begin();
    for (std::int32_t row = rows[i].first; row <= rows[i].last; ++row, from += columns_)
      std::transform(from, from + columns_, &words_[static_cast<std::size_t>(row + 1) * stride + 1],
                     whole);
    std::transform(part.divided_words.begin(), part.divided_words.end(),
                   words_.data() + first_word[i], whole);
    std::copy(part.slots.begin(), part.slots.end(), slots_.data() + first_record[i]);
    std::copy(part.records.begin(), part.records.end(), records_.data() + 4 * first_record[i]);
  });
}

void CellGrid::fill_list(const Surfaces& walls) {
  for (std::uint32_t slot = 0; slot < slots(walls); ++slot)
    if (!is_copy(slot)) slots_.push_back(slot);
  records_.resize(4 * (slots_.size() + kBeyond));
  for (std::size_t i = 0; i < slots_.size(); ++i)
    write_record(walls, slots_[i], i + 1 == slots_.size(), &records_[4 * i]);
}

void CellGrid::write_record(const Surfaces& walls, std::size_t slot, bool is_last,
                            float* record) const {
  visit(walls, slot, [&](const auto& wall) {
    const std::array<float, 4> row = record_of(wall, slot, is_last, 0x1p24 * unit_);
    std::copy_n(row.data(), 4, record);
  });
}

}  // namespace flatray
