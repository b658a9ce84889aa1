#pragma once
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geom/bounds.h"

namespace flatray {

/// Boxes to be asked which of them meet another, one question at a time, while some of them change. They
/// lie in the cells of a grid that goes round and round, so that it does not matter how far apart they
/// are.
///
/// Cost    a box is put into the cells it touches, as wide as half of all boxes are; one that touches
///         many is looked at by all, and looks at all.
class BoxGrid {
 public:
  explicit BoxGrid(std::vector<Bounds> boxes);

  std::span<const Bounds> boxes() const { return boxes_; }
  void change(std::uint32_t number, const Bounds& box);

  /// Calls `take(number)` once for those that have a point in common with `box`, in any order, but the
  /// same every time.
  template <class Take>
  void each_near(const Bounds& box, const Take& take) {
    if (box.empty()) return;
    ++asked_;
    const auto look = [&](std::uint32_t k) {
      if (seen_[k] == asked_) return;
      seen_[k] = asked_;
      if (box.meets(boxes_[k])) take(k);
    };
    for (const std::uint32_t k : large_) look(k);
    const bool is_large = !each_list(box, [&](std::size_t list) {
      for (std::uint32_t i = first_[list]; i != kNone; i = entries_[i].next)
        look(entries_[i].number);
    });
    for (std::size_t i = 0; is_large && i < entries_.size(); ++i) look(entries_[i].number);
  }

 private:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};
  struct Entry {
    std::uint32_t number, next;
  };

  // Calls `take(list)` for the list of each cell that a box touches; not if there are many.
  template <class Take>
  bool each_list(const Bounds& box, const Take& take) const;
  void put_in_cells();
  void put_in_cells(std::uint32_t number);

  std::vector<Bounds> boxes_;
  std::vector<std::uint64_t> seen_;  // the last question in which each came up
  std::uint64_t asked_ = 0;
  double width_ = 1;        // of a cell
  std::size_t across_ = 1;  // a power of two, of which the square is how many lists there are
  std::vector<std::uint32_t> first_;  // entry of each list
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> large_;
  std::size_t most_kept_ = 0;  // boxes in cells, until they are put there anew
};

template <class Take>
bool BoxGrid::each_list(const Bounds& box, const Take& take) const {
  constexpr double kMost = 0x1p52;  // cells from the origin that are counted one by one
  constexpr std::int64_t kMostCells = 64;
  const Vec2 low = box.low / width_, high = box.high / width_;
  if (!(low.minCoeff() > -kMost && high.maxCoeff() < kMost)) return false;
  const auto cell = [](double place) { return static_cast<std::int64_t>(std::floor(place)); };
  const std::int64_t low_x = cell(low.x()), high_x = cell(high.x());
  const std::int64_t low_y = cell(low.y()), high_y = cell(high.y());
  const std::int64_t wide = high_x - low_x + 1, tall = high_y - low_y + 1;
  if (wide > kMostCells || tall > kMostCells || wide * tall > kMostCells) return false;
  // So that a row, a column and a diagonal, too, go through all lists and not through the root of them.
  for (std::int64_t y = low_y; y <= high_y; ++y)
    for (std::int64_t x = low_x; x <= high_x; ++x)
      take((static_cast<std::size_t>(x) + static_cast<std::size_t>(y) * (across_ + 3)) &
           (across_ * across_ - 1));
  return true;
}

}  // namespace flatray
