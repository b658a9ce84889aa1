#include "render/gl/grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

namespace {

// Sides that one line across `axis` meets, at most. A side ends before where another begins.
std::size_t most_met(std::span<const std::vector<GridPoint>> figures,
                     std::int64_t GridPoint::*axis) {
  std::vector<std::pair<std::int64_t, int>> steps;
  for (const std::vector<GridPoint>& figure : figures)
    for (std::size_t i = 0; i < figure.size(); ++i) {
      const auto [low, high] = std::minmax(figure[i].*axis, figure[(i + 1) % figure.size()].*axis);
      if (low != high) steps.insert(steps.end(), {{low, 1}, {high, -1}});
    }
  std::sort(steps.begin(), steps.end());
  std::ptrdiff_t met = 0, most = 0;
  for (const auto& [at, step] : steps) most = std::max(most, met += step);
  return static_cast<std::size_t>(most);
}

}  // namespace

std::size_t most_windings(std::span<const std::vector<GridPoint>> figures, std::size_t enough) {
  std::size_t sides = 0;
  for (const std::vector<GridPoint>& figure : figures) sides += figure.size();
  if (sides / 2 <= enough) return enough;
  return std::min(most_met(figures, &GridPoint::x), most_met(figures, &GridPoint::y)) / 2;
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
