#pragma once
#include <memory>
#include <span>

#include "geom/vec.h"

namespace bench {

/// Pairs of moving convex polygons as Box2D asks when they first come within its slop of each other.
class Box2dPairs {
 public:
  Box2dPairs();
  Box2dPairs(Box2dPairs&&) noexcept;
  ~Box2dPairs();
  void add(std::span<const flatray::Vec2> a, const flatray::Vec2& velocity_a,
           std::span<const flatray::Vec2> b, const flatray::Vec2& velocity_b);
  /// In [0, 1]; 2 where they do not meet.
  double first_time(std::size_t pair) const;

 private:
  struct Inputs;
  std::unique_ptr<Inputs> inputs_;
};

}  // namespace bench
