#include "render/gl/grid.h"

#include <algorithm>
#include <cmath>

namespace flatray::gl {

GridPoint on_grid(const Vec2& point) {
  const auto nearest = [](double value) {
    return static_cast<std::int64_t>(std::floor(value * kGridSteps + 0.5));
  };
  return {nearest(point.x()), nearest(point.y())};
}

std::int64_t area(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Andrew's two chains.
std::vector<GridPoint> hull(std::vector<GridPoint> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return {};
  std::vector<GridPoint> corners;
  const auto add = [&](const GridPoint& point, std::size_t kept) {
    while (corners.size() > kept + 1 &&
           area(corners[corners.size() - 2], corners.back(), point) <= 0)
      corners.pop_back();
    corners.push_back(point);
  };
  for (const GridPoint& point : points) add(point, 0);
  const std::size_t lower = corners.size() - 1;
  for (auto point = points.rbegin() + 1; point != points.rend(); ++point) add(*point, lower);
  corners.pop_back();  // the first again
  return corners.size() < 3 ? std::vector<GridPoint>() : corners;
}

}  // namespace flatray::gl
