#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "anim/responses.h"
#include "collide/broad_phase.h"
#include "collide/outline_contact.h"

namespace flatray {

/// Which of many bodies may meet in a while, by the boxes they sweep, while some of them change their
/// ways.
class NearBodies {
 public:
  /// A box around each body as seen from its origin.
  explicit NearBodies(std::vector<Bounds> shapes);

  /// A new while: from one time to another, `stages` what each body does at its beginning; nullptr for
  /// one that plays no part.
  void open(double from, double to, std::span<const Stage* const> stages);
  /// A body goes on by another stage from its time on.
  void change(std::uint32_t body, const Stage& stage);

  /// Calls `take(a, b)`, a < b, once for all pairs that may meet in the while as it was opened.
  template <class Take>
  void each_pair(const Take& take) {
    for (std::uint32_t i = 0; i < boxes_.size(); ++i)
      each_near(i, [&](std::uint32_t k) {
        if (k < i) take(k, i);
      });
  }
  /// Calls `take(k)` once for all others that a body may meet in the rest of the while.
  template <class Take>
  void each_near(std::uint32_t body, const Take& take) {
    const Bounds& box = boxes_[body];
    if (box.empty()) return;
    ++asked_;
    seen_[body] = asked_;
    cells_->visit(box, [&](std::uint32_t k) {
      if (seen_[k] == asked_) return;
      seen_[k] = asked_;
      if (meet(box, boxes_[k])) take(k);
    });
  }

 private:
  static bool meet(const Bounds& a, const Bounds& b) {
    return a.low.x() <= b.high.x() && b.low.x() <= a.high.x() && a.low.y() <= b.high.y() &&
           b.low.y() <= a.high.y();
  }
  void put_in_cells();
  Bounds way_of(std::uint32_t body, const Stage& stage, double from) const;

  std::vector<Bounds> shapes_, boxes_;
  std::vector<std::uint64_t> seen_;  // the last question in which each came up
  std::uint64_t asked_ = 0;
  std::optional<BoxCells> cells_;
  std::size_t most_kept_ = 0;  // boxes in cells, until they are put there anew
  double to_ = 0;
};

/// Box around the parts of a body.
Bounds bounds_of(std::span<const ShapePart> parts);

}  // namespace flatray
