#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "geom/bounds.h"

namespace flatray {

/// Calls `take(a, b)`, a < b, once for every pair of boxes that have a point in common, in any order,
/// until it says false: not for two that are both left out.
///
/// Gives   none with an empty box.
/// Cost    O(n log n + pairs), whatever the boxes; memory O(n), and only the first is spent on those left
///         out.
/// Source  Zomorodian and Edelsbrunner 2000: boxes by segment trees that are not kept.
void each_overlap(std::span<const Bounds> boxes, const std::vector<bool>& left_out,
                  const std::function<bool(std::uint32_t, std::uint32_t)>& take);

/// All of them, ascending.
std::vector<std::pair<std::uint32_t, std::uint32_t>> overlapping_pairs(
    std::span<const Bounds> boxes);

/// A box around all places of `box` while it moves by velocity * t, t in [0, length]; outward by
/// more than rounding can lose.
Bounds swept(const Bounds& box, const Vec2& velocity, double length);

/// Boxes by the cells of a grid that goes round and round, so that it does not matter how far apart
/// they lie: to be asked which lie near another while some of them change.
///
/// Cost    a box is put into the cells it touches, as wide as half of all boxes are; one that touches
///         many is looked at by all.
class BoxCells {
 public:
  /// Of all boxes; the empty ones are left out.
  explicit BoxCells(std::span<const Bounds> boxes);

  /// Another box of body `number`, beside those it has.
  void add(std::uint32_t number, const Bounds& box);

  /// Places where boxes are kept, one more for each cell a box was put into.
  std::size_t size() const { return entries_.size() + large_.size(); }

  /// Calls `take(number)` for every body with a box that meets this one, for some others too, and for
  /// some more than once. Needs   a box that is not empty.
  template <class Take>
  void visit(const Bounds& box, const Take& take) const {
    for (const std::uint32_t number : large_) take(number);
    const auto cells = cells_of(box);
    if (!cells) {
      for (const Entry& entry : entries_) take(entry.number);
      return;
    }
    for (std::int64_t y = cells->low_y; y <= cells->high_y; ++y)
      for (std::int64_t x = cells->low_x; x <= cells->high_x; ++x)
        for (std::uint32_t i = first_[slot(x, y)]; i != kNone; i = entries_[i].next)
          take(entries_[i].number);
  }

 private:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};
  struct Entry {
    std::uint32_t number, next;
  };
  struct Cells {
    std::int64_t low_x, high_x, low_y, high_y;
  };
  /// nullopt for a box that touches many.
  std::optional<Cells> cells_of(const Bounds& box) const;
  std::size_t slot(std::int64_t x, std::int64_t y) const {
    // So that a row, a column and a diagonal, too, go through all lists and not through the root of them.
    return (static_cast<std::size_t>(x) + static_cast<std::size_t>(y) * (across_ + 3)) &
           (across_ * across_ - 1);
  }

  double width_ = 1;        // of a cell
  std::size_t across_ = 1;  // a power of two, of which the square is how many lists there are
  std::vector<std::uint32_t> first_;
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> large_;
};

}  // namespace flatray
