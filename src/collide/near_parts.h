#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "collide/outline_contact.h"
#include "geom/box_tree.h"

namespace flatray {

/// The parts of a shape, to be asked which of them a part of another may meet.
///
/// Cost    n log n to make; an answer the logarithm and what it finds, where parts are small beside the shape.
///         Of a few parts all are found at once, which is as fast.
class NearParts {
 public:
  explicit NearParts(std::span<const ShapePart> parts);

  /// The numbers, ascending, of all that may meet `part` within a range of time, while it moves by `velocity` as
  /// seen from them, rounded.
  ///
  /// Gives   all of them where one or the other is an ellipse, or the range is endless or begins before 0.
  std::vector<std::size_t> near(const ShapePart& part, const Vec2& velocity, Range within) const;

 private:
  const std::size_t count_;
  const BoxTree boxes_;
};

}  // namespace flatray
