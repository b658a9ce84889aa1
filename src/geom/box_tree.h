#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "geom/bounds.h"

namespace flatray {

/// Boxes to be asked which of them meet another.
///
/// Cost    n log n to make; an answer the logarithm and what it finds, where boxes are small beside all of them.
class BoxTree {
 public:
  explicit BoxTree(std::vector<Bounds> boxes);

  /// The numbers of those that have a point in common with `box`, in any order, but the same every time.
  std::vector<std::size_t> near(const Bounds& box) const;

 private:
  void part(std::size_t begin, std::size_t end);
  void find(const Bounds& box, std::size_t begin, std::size_t end,
            std::vector<std::size_t>& found) const;

  // The middle one of a stretch of `order_` parts it in two along its longer side, and keeps the box of all of it.
  std::vector<Bounds> boxes_;
  std::vector<std::size_t> order_;
  std::vector<Bounds> around_;
};

}  // namespace flatray
