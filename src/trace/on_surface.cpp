#include "trace/on_surface.h"

#include <algorithm>

namespace flatray {

bool lies_on(const Vec2& point, const Segment& segment) {
  const auto between = [&](int axis) {
    const auto [low, high] = std::minmax(segment.a[axis], segment.b[axis]);
    return low <= point[axis] && point[axis] <= high;
  };
  return between(0) && between(1) && orientation(segment.a, segment.b, point) == Sign::zero;
}

}  // namespace flatray
