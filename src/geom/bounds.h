#pragma once
#include <span>
#include <vector>

#include "geom/ray.h"

namespace flatray {

/// Closed box with sides along the axes; empty while low > high.
struct Bounds {
  Vec2 low{kInfinity, kInfinity}, high{-kInfinity, -kInfinity};

  bool empty() const { return !(low.x() <= high.x() && low.y() <= high.y()); }
  void add(const Vec2& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  void add(const Bounds& other) {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
  }
  bool contains(const Vec2& point) const {
    return low.x() <= point.x() && point.x() <= high.x() && low.y() <= point.y() &&
           point.y() <= high.y();
  }
  /// Whether both have a point in common. An empty box meets no finite one.
  bool meets(const Bounds& other) const {
    return low.x() <= other.high.x() && other.low.x() <= high.x() && low.y() <= other.high.y() &&
           other.low.y() <= high.y();
  }
  Vec2 size() const { return high - low; }
  Vec2 centre() const { return 0.5 * low + 0.5 * high; }
  /// From the lowest on, counter-clockwise.
  std::vector<Vec2> corners() const {
    return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
  }
};

/// The least box that holds all points.
inline Bounds box_about(std::span<const Vec2> points) {
  Bounds box;
  for (const Vec2& point : points) box.add(point);
  return box;
}

}  // namespace flatray
