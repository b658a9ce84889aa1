#include "collide/polygon_set.h"

#include <cmath>

#include "collide/minkowski.h"
#include "geom/bounds.h"
#include "geom/polygon.h"

namespace flatray {
namespace {

using Ready = PolygonSet::Ready;
constexpr double kUp = 1 + 0x1p-40;

// Above, floats could overflow.
constexpr double kLargestRadius = 0x1p60;

void set_corners(std::span<const Vec2> ring, std::span<const std::uint32_t> numbers,
                 bool turned_round, Ready& ready) {
  const std::size_t count = numbers.size();
  ready.count = static_cast<int>(count);
  for (std::size_t k = 0; k <= count; ++k) {
    ready.corners[k] = ring[numbers[k % count]];
    ready.numbers[k] = static_cast<std::int32_t>(numbers[k % count]);
  }
  for (std::size_t k = 0; k < count; ++k) ready.edges[k] = ready.numbers[turned_round ? k + 1 : k];
}

void set_lanes(Ready& ready) {
  const std::span<const Vec2> corners(ready.corners.data(), static_cast<std::size_t>(ready.count));
  for (std::size_t lane = 0; lane < sweep::kCorners; ++lane) {
    const std::size_t k = lane < corners.size() ? lane : 0;
    const Vec2 from = corners[k] - ready.centre, along = ready.corners[k + 1] - corners[k];
    const double length = std::sqrt(along.squaredNorm());
    const auto x = static_cast<float>(along.y() / length);
    const auto y = static_cast<float>(-along.x() / length);
    double reach = -kLargestRadius;
    for (const Vec2& corner : corners) {
      const Vec2 p = corner - ready.centre;
      reach = std::max(reach, static_cast<double>(x) * p.x() + static_cast<double>(y) * p.y());
    }
    ready.lanes.normal_x[lane] = x;
    ready.lanes.normal_y[lane] = y;
    ready.lanes.reach[lane] = static_cast<float>(reach);
    ready.lanes.x[lane] = static_cast<float>(from.x());
    ready.lanes.y[lane] = static_cast<float>(from.y());
  }
}

bool are_usual(const sweep::Shape& lanes) {
  for (int lane = 0; lane < sweep::kCorners; ++lane)
    if (!(std::fabs(lanes.normal_x[lane]) <= 1 && std::fabs(lanes.normal_y[lane]) <= 1))
      return false;
  return true;
}

Ready made_ready(std::span<const Vec2> ring) {
  Ready ready{};
  const Sign sense = ring_orientation(ring);
  if (sense == Sign::zero) return ready;
  const std::vector<std::uint32_t> numbers = turned_ring(ring, sense);
  if (numbers.size() > sweep::kCorners) return ready;
  Bounds box;
  for (const Vec2& p : ring) box.add(p);
  ready.centre = 0.5 * box.low + 0.5 * box.high;
  ready.half = kUp * (ready.centre - box.low).cwiseMax(box.high - ready.centre);
  for (const Vec2& p : ring)
    ready.radius = std::max(ready.radius, kUp * std::sqrt((p - ready.centre).squaredNorm()));
  if (!(ready.radius > 1 / kLargestRadius && ready.radius < kLargestRadius)) return ready;
  set_corners(ring, numbers, sense == Sign::negative, ready);
  set_lanes(ready);
  if (!are_usual(ready.lanes)) ready.count = 0;
  return ready;
}

}  // namespace

std::uint32_t PolygonSet::add(std::span<const Vec2> ring) {
  const auto number = static_cast<std::uint32_t>(size());
  vertices_.insert(vertices_.end(), ring.begin(), ring.end());
  begin_.push_back(vertices_.size());
  ready_.push_back(made_ready(ring));
  return number;
}

}  // namespace flatray
