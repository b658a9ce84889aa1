#include "trace/hit_intervals.h"

#include <algorithm>
#include <array>

#include "geom/bounds.h"
#include "geom/clip_range.h"
#include "geom/polygon.h"
#include "trace/kernels/tiers.h"
#include "trace/ray_block.h"

namespace flatray {
namespace {

constexpr std::size_t kBlock =
    256;  // rays of a call of the kernel: what it gives stays in the first cache
static_assert(kBlock % lanes::kWidest == 0);

// The ring closed by its first vertex, as the kernels take it too.
struct ClosedRing {
  std::vector<Vec2> vertices;
  lanes::Polygon polygon;

  explicit ClosedRing(std::span<const Vec2> ring) : vertices(ring.begin(), ring.end()) {
    vertices.push_back(ring.front());
    const auto [low, high] = box_about(ring);
    polygon = {vertices.front().data(),
               static_cast<int>(ring.size()),
               low.x(),
               low.y(),
               high.x(),
               high.y()};
  }
};

HitTime time_on_edge(const Ray& ray, const ClosedRing& ring, int edge) {
  const auto from = static_cast<std::size_t>(edge);
  return HitTime::on_line(ray, {ring.vertices[from], ring.vertices[from + 1]});
}

// A counter-clockwise ring is entered where its vertices change from left to right.
HitInterval finish(const Ray& ray, const ClosedRing& ring, Sign turn, double down, double up,
                   Range within) {
  const bool forward = turn == Sign::positive;
  const int enter = static_cast<int>(forward ? down : up);
  const int exit = static_cast<int>(forward ? up : down);
  return clip_to_range(LineHit{time_on_edge(ray, ring, enter), time_on_edge(ray, ring, exit), enter,
                               exit, HitClass::through},
                       within);
}

}  // namespace

void clip_convex_batch(const RayBatch& rays, std::span<const Vec2> polygon, Range within,
                       std::span<HitInterval> intervals, Isa isa) {
  const Sign turn = polygon.empty() ? Sign::zero : ring_orientation(polygon);
  if (turn == Sign::zero) {  // a segment or a point
    for (std::size_t i = 0; i < rays.size(); ++i)
      intervals[i] = clip_convex(rays.ray(i), polygon, within);
    return;
  }
  const ClosedRing ring(polygon);
  RayBlock block;
  std::array<double, kBlock> down, up;
  for (std::size_t begin = 0; begin < rays.size(); begin += kBlock) {
    const std::size_t count = std::min(kBlock, rays.size() - begin);
    lane_kernels(isa).clip(ring.polygon, block.take(rays, begin, count), {down.data(), up.data()});
    for (std::size_t i = 0; i < count; ++i) {
      const Ray ray = rays.ray(begin + i);
      intervals[begin + i] = down[i] == lanes::kMissed ? HitInterval{}
                             : down[i] == lanes::kUnsure
                                 ? clip_convex(ray, polygon, within)
                                 : finish(ray, ring, turn, down[i], up[i], within);
    }
  }
}

}  // namespace flatray
