#include "collide/body_set.h"

#include <cmath>

#include "collide/minkowski.h"
#include "geom/bounds.h"
#include "geom/polygon.h"

namespace flatray {
namespace {

using Ready = BodySet::Ready;
constexpr double kUp = 1 + 0x1p-40;

void set_corners(std::span<const Vec2> ring, std::span<const std::uint32_t> numbers,
                 bool turned_round, Ready& ready) {
  const std::size_t count = numbers.size();
  ready.count = static_cast<int>(count);
  for (std::size_t k = 0; k < count + 2; ++k)
    ready.around[k] = ring[numbers[(k + count - 1) % count]];
  for (std::size_t k = 0; k < count; ++k) {
    ready.numbers[k] = static_cast<std::int32_t>(numbers[k]);
    ready.edges[k] = static_cast<std::int32_t>(numbers[turned_round ? (k + 1) % count : k]);
  }
}

// Whether all normals are usual.
bool set_lanes(const Vec2& centre, Ready& ready) {
  const std::span<const Vec2> corners(&ready.corner(0), static_cast<std::size_t>(ready.count));
  bool usual = true;
  for (std::size_t lane = 0; lane < pairs::kCorners; ++lane) {
    const std::size_t k = lane < corners.size() ? lane : 0;
    const Vec2 from = corners[k] - centre, along = (&corners[k])[1] - corners[k];
    const double length = std::sqrt(along.squaredNorm());
    const auto x = static_cast<float>(along.y() / length);
    const auto y = static_cast<float>(-along.x() / length);
    double reach = -pairs::kLargest;
    for (const Vec2& corner : corners) {
      const Vec2 p = corner - centre;
      reach = std::max(reach, static_cast<double>(x) * p.x() + static_cast<double>(y) * p.y());
    }
    ready.lanes.normal_x[lane] = x;
    ready.lanes.normal_y[lane] = y;
    ready.lanes.reach[lane] = static_cast<float>(reach);
    ready.lanes.x[lane] = static_cast<float>(from.x());
    ready.lanes.y[lane] = static_cast<float>(from.y());
    usual = usual && std::fabs(x) <= 1 && std::fabs(y) <= 1;
  }
  return usual;
}

// Whether it is a polygon for the lanes, and then made ready.
bool make_ready(std::span<const Vec2> ring, const BodySet::Box& box, Ready& ready) {
  const double half = box.half.maxCoeff();
  if (!(half > 1 / pairs::kLargest && half < pairs::kLargest)) return false;
  const Sign sense = ring_orientation(ring);
  if (sense == Sign::zero) return false;
  const std::vector<std::uint32_t> numbers = turned_ring(ring, sense);
  if (numbers.size() > pairs::kCorners) return false;
  set_corners(ring, numbers, sense == Sign::negative, ready);
  return set_lanes(box.centre, ready);
}

}  // namespace

std::uint32_t BodySet::add(std::span<const Vec2> core, double radius) {
  const auto number = static_cast<std::uint32_t>(size());
  Bounds around;
  for (const Vec2& p : core) around.add(p);
  const Vec2 centre = 0.5 * around.low + 0.5 * around.high;
  const Vec2 half = kUp * ((centre - around.low).cwiseMax(around.high - centre).array() + radius);
  vertices_.insert(vertices_.end(), core.begin(), core.end());
  begin_.push_back(vertices_.size());
  boxes_.push_back({centre, half});
  Ready& ready = ready_.emplace_back();
  is_ready_.push_back(radius == 0 && make_ready(core, boxes_.back(), ready));
  radii_.push_back(radius);
  return number;
}

}  // namespace flatray
