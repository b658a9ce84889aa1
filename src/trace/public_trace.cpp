#include <algorithm>
#include <cmath>
#include <memory>

#include "flatray/trace.h"
#include "trace/hit_intervals.h"
#include "trace/many_rays.h"
#include "trace/plain_arrays.h"
#include "trace/tracer.h"
#include "trace/walls_data.h"

namespace flatray::api {
namespace {

static_assert(kNoWall == kNoSurface && static_cast<int>(Root::both) == 3 &&
              static_cast<int>(flatray::Root::both) == 3 &&
              static_cast<int>(Root::fourth) == static_cast<int>(flatray::Root::fourth) &&
              static_cast<int>(HitClass::through) == static_cast<int>(flatray::HitClass::through) &&
              static_cast<int>(StartPlace::inside) ==
                  static_cast<int>(flatray::StartPlace::inside));

Hit hit_of(const NearestHit& hit) {
  return {hit.t, hit.surface, static_cast<HitClass>(hit.kind), static_cast<Root>(hit.root),
          hit.at_end};
}

// Calls `ask(batch, begin)` for all rays, some thousand at a time.
template <class Ask>
void in_batches(const Rays& rays, const Ask& ask) {
  RayBatch batch;
  for (std::size_t begin = 0; begin < rays.size(); begin += kRaysAtOnce) {
    load(rays, begin, std::min(kRaysAtOnce, rays.size() - begin), batch);
    ask(batch, begin);
  }
}

Status check_clip(const Rays& rays, Range within, std::span<Interval> intervals) {
  const Rays bare{rays.ox, rays.oy, rays.dx, rays.dy};
  if (const Status fault = check_rays(bare, 0); !fault) return fault;
  if (intervals.size() != rays.size()) return {Fault::sizes, 0};
  return check_range(within);
}

}  // namespace

struct RayTracer::Data {
  Walls walls;
  std::unique_ptr<Accelerator> ready;

  Data(Walls&& taken, unsigned threads)
      : walls(std::move(taken)),
        ready(accelerate(std::as_const(walls).data().surfaces, std::max(1U, threads))) {}
};

RayTracer::RayTracer(Walls walls, unsigned threads) : data_(new Data(std::move(walls), threads)) {}
RayTracer::RayTracer(RayTracer&&) noexcept = default;
RayTracer& RayTracer::operator=(RayTracer&&) noexcept = default;
RayTracer::~RayTracer() = default;

std::size_t RayTracer::walls() const { return data_ ? data_->walls.size() : 0; }

Status RayTracer::nearest(const Rays& rays, std::span<Hit> hits) const {
  if (const Status fault = check_rays(rays, walls()); !fault) return fault;
  if (hits.size() != rays.size()) return {Fault::sizes, 0};
  std::fill(hits.begin(), hits.end(), Hit{});
  if (!data_) return {};
  std::vector<NearestHit> found(std::min(kRaysAtOnce, rays.size()));
  in_batches(rays, [&](const RayBatch& batch, std::size_t begin) {
    data_->ready->nearest(batch, std::span(found).first(batch.size()));
    std::transform(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(batch.size()),
                   hits.begin() + static_cast<std::ptrdiff_t>(begin), hit_of);
  });
  return {};
}

Status RayTracer::any(const Rays& rays, std::span<const double> up_to,
                      std::span<std::uint8_t> met) const {
  if (const Status fault = check_rays(rays, walls()); !fault) return fault;
  if (up_to.size() != rays.size() || met.size() != rays.size()) return {Fault::sizes, 0};
  for (std::size_t i = 0; i < up_to.size(); ++i)
    if (std::isnan(up_to[i])) return {Fault::not_finite, i};
  std::fill(met.begin(), met.end(), std::uint8_t{0});
  if (!data_) return {};
  in_batches(rays, [&](const RayBatch& batch, std::size_t begin) {
    data_->ready->any(batch, up_to.subspan(begin, batch.size()), met.subspan(begin, batch.size()));
  });
  return {};
}

Status RayTracer::all(const Rays& rays, std::vector<Hit>& hits,
                      std::vector<std::size_t>& ends) const {
  if (const Status fault = check_rays(rays, walls()); !fault) return fault;
  hits.clear();
  ends.assign(rays.size(), 0);
  if (!data_) return {};
  in_batches(rays, [&](const RayBatch& batch, std::size_t begin) {
    for (std::size_t i = 0; i < batch.size(); ++i) {
      for (const NearestHit& hit :
           data_->ready->all_of_one(batch.ray(i), batch.departed[i], batch.tangents))
        hits.push_back(hit_of(hit));
      ends[begin + i] = hits.size();
    }
  });
  return {};
}

Status clip_convex(const Rays& rays, Column x, Column y, Range within,
                   std::span<Interval> intervals) {
  if (const Status fault = check_clip(rays, within, intervals); !fault) return fault;
  if (const Status fault = check_convex(x, y); !fault) return fault;
  const std::vector<Vec2> polygon = points_of(x, y);
  std::vector<HitInterval> found(std::min(kRaysAtOnce, rays.size()));
  in_batches(rays, [&](const RayBatch& batch, std::size_t begin) {
    clip_convex_batch(batch, polygon, {within.low, within.high},
                      std::span(found).first(batch.size()));
    std::transform(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(batch.size()),
                   intervals.begin() + static_cast<std::ptrdiff_t>(begin), interval_of);
  });
  return {};
}

Status clip_disc(const Rays& rays, double x, double y, double radius, Range within,
                 std::span<Interval> intervals) {
  if (const Status fault = check_clip(rays, within, intervals); !fault) return fault;
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(radius))
    return {Fault::not_finite, 0};
  if (radius < 0) return {Fault::radius, 0};
  for (std::size_t i = 0; i < rays.size(); ++i)
    intervals[i] =
        interval_of(clip_circle(ray_of(rays, i), {{x, y}, radius}, {within.low, within.high}));
  return {};
}

}  // namespace flatray::api
