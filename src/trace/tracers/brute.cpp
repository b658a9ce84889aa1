#include "trace/tracers/brute.h"

#include <array>

#include "geom/bounds.h"
#include "trace/exact_nearest.h"
#include "trace/kernels/tiers.h"
#include "trace/ray_block.h"
#include "trace/tracer.h"

namespace flatray {
namespace {

lanes::Walls lane_walls(const Surfaces& walls) {
  static_assert(sizeof(Segment) == 4 * sizeof(double));
  Bounds box;
  for (const Segment& segment : walls.segments) {
    box.add(segment.a);
    box.add(segment.b);
  }
  return {walls.segments.empty() ? nullptr : walls.segments.front().a.data(),
          static_cast<int>(walls.segments.size()),
          box.low.x(),
          box.low.y(),
          box.high.x(),
          box.high.y()};
}

double left_slot(const Surfaces& walls, const Left& left) {
  if (left.surface == kNoSurface || walls.kinds[left.surface] != SurfaceKind::segment)
    return lanes::kNothing;
  return walls.slot[left.surface];
}

NearestHit decide_ray(const Surfaces& walls, const RayBatch& rays, std::size_t i, double slot) {
  const bool sure = slot != lanes::kDoubtful;
  if (sure && walls.circles.empty())
    return slot < 0 ? NearestHit{}
                    : crossing_hit(walls, rays.ray(i), static_cast<std::size_t>(slot));
  ExactNearest search(walls, rays.ray(i), rays.left[i], rays.tangents);
  if (slot >= 0)
    search.offer_segment(static_cast<std::size_t>(slot));
  else if (!sure)
    search.offer_segments();
  search.offer_circles();
  return search.hit();
}

class Brute : public Accelerator {
 public:
  explicit Brute(const Surfaces& walls) : walls_(walls) {}
  void nearest(const RayBatch& rays, std::span<NearestHit> hits) const override {
    brute_nearest(walls_, rays, hits, active_isa());
  }
  std::size_t bytes() const override { return 0; }

 private:
  const Surfaces& walls_;
};

std::unique_ptr<Accelerator> build(const Surfaces& walls) { return std::make_unique<Brute>(walls); }

}  // namespace

void brute_nearest(const Surfaces& walls, const RayBatch& rays, std::span<NearestHit> hits,
                   Isa isa) {
  const lanes::Kernels& kernels = lane_kernels(isa);
  const lanes::Walls segments = lane_walls(walls);
  RayBlock block;
  std::array<double, kRayBlock> slots;
  for (std::size_t begin = 0; begin < rays.size(); begin += kRayBlock) {
    const std::size_t count = block.load(rays, begin);
    for (std::size_t i = 0; i < count; ++i) block.left[i] = left_slot(walls, rays.left[begin + i]);
    kernels.nearest(segments, block.lanes(), {slots.data()});
    for (std::size_t i = 0; i < count; ++i)
      hits[begin + i] = decide_ray(walls, rays, begin + i, slots[i]);
  }
}

extern const Tracer brute_tracer;
const Tracer brute_tracer = {"brute", "every wall against every ray, culled in vector lanes", true,
                             &build};

}  // namespace flatray
