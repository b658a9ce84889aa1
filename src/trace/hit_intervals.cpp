#include "trace/hit_intervals.h"

#include <algorithm>

#include "geom/bounds.h"
#include "geom/hit_time.h"
#include "geom/polygon.h"
#include "trace/kernels/tiers.h"
#include "trace/ray_block.h"

namespace flatray {
namespace {

struct Verdicts {
  std::array<double, kRayBlock> enter, exit, start;
};

// The ring closed by its first vertex, and its box.
struct ClosedRing {
  std::vector<Vec2> vertices;
  Bounds box;
  explicit ClosedRing(std::span<const Vec2> polygon) : vertices(polygon.begin(), polygon.end()) {
    vertices.push_back(polygon.front());
    for (const Vec2& vertex : polygon) box.add(vertex);
  }
};

lanes::Polygon lane_polygon(const ClosedRing& ring, Sign turn, Range within) {
  return {ring.vertices.front().data(),
          static_cast<int>(ring.vertices.size() - 1),
          static_cast<double>(turn),
          within.low,
          within.high,
          ring.box.low.x(),
          ring.box.low.y(),
          ring.box.high.x(),
          ring.box.high.y()};
}

// t where the ray crosses an edge, or the end of the range where there is none.
void finish_end(const Ray& ray, const ClosedRing& ring, double edge, double range_end, int& number,
                double& t, bool& overflows) {
  t = range_end;
  if (edge < 0) return;
  number = static_cast<int>(edge);
  const auto from = static_cast<std::size_t>(number);
  const RoundedTime time =
      HitTime::on_line(ray, {ring.vertices[from], ring.vertices[from + 1]}).nearest();
  t = time.t;
  overflows = time.overflows;
}

HitInterval finish_through(const Ray& ray, const ClosedRing& ring, Range within,
                           const Verdicts& verdicts, std::size_t i) {
  HitInterval hit;
  hit.kind = HitClass::through;
  hit.start = verdicts.start[i] > 0 ? StartPlace::inside : StartPlace::outside;
  finish_end(ray, ring, verdicts.enter[i], within.low, hit.edge_enter, hit.t_enter,
             hit.enter_overflows);
  finish_end(ray, ring, verdicts.exit[i], within.high, hit.edge_exit, hit.t_exit,
             hit.exit_overflows);
  return hit;
}

}  // namespace

void clip_convex_batch(const RayBatch& rays, std::span<const Vec2> polygon, Range within,
                       std::span<HitInterval> intervals, Isa isa) {
  const Sign turn = polygon.empty() ? Sign::zero : ring_orientation(polygon);
  if (turn == Sign::zero) {
    for (std::size_t i = 0; i < rays.size(); ++i)
      intervals[i] = clip_convex(rays.ray(i), polygon, within);
    return;
  }
  const ClosedRing ring(polygon);
  const lanes::Polygon lane_ring = lane_polygon(ring, turn, within);
  RayBlock block;
  Verdicts verdicts;
  for (std::size_t begin = 0; begin < rays.size(); begin += kRayBlock) {
    const std::size_t count = block.load(rays, begin);
    lane_kernels(isa).clip(lane_ring, block.lanes(),
                           {verdicts.enter.data(), verdicts.exit.data(), verdicts.start.data()});
    for (std::size_t i = 0; i < count; ++i) {
      const Ray ray = rays.ray(begin + i);
      if (verdicts.enter[i] == lanes::kMissed)
        intervals[begin + i] = {};
      else if (verdicts.enter[i] == lanes::kUnsure)
        intervals[begin + i] = clip_convex(ray, polygon, within);
      else
        intervals[begin + i] = finish_through(ray, ring, within, verdicts, i);
    }
  }
}

}  // namespace flatray
