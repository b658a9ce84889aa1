#pragma once
#include <fmt/core.h>

#include "measure.h"
#include "trace/tracer.h"
#include "trace_scenes.h"
#include "tracing.h"

namespace bench {

/// A tracer of this project.
class Flatray : public Tracing {
 public:
  Flatray(const flatray::Tracer& tracer, const flatray::Surfaces& walls)
      : name_(tracer.name), exact_(tracer.exact) {
    const double start = seconds(CLOCK_THREAD_CPUTIME_ID);
    walls_ = tracer.build(walls);
    const double spent = seconds(CLOCK_THREAD_CPUTIME_ID) - start;
    remark_ = fmt::format("{:.1f} bytes a segment, built in {:.2f} ms",
                          static_cast<double>(walls_->bytes()) / static_cast<double>(walls.size()),
                          1e3 * spent);
  }
  std::string name() const override { return "flatray, " + name_; }
  std::string remark() const override { return remark_; }
  std::string arithmetic() const override {
    return exact_ ? "exact" : name_.ends_with("float") ? "floats" : "doubles";
  }
  void take(const flatray::RayBatch& rays) override {
    rays_ = rays;
    hits_.resize(rays.size());
  }
  void trace() override { walls_->nearest(rays_, hits_); }
  Met met(std::size_t ray) const override { return {hits_[ray].surface, hits_[ray].t}; }
  void turn(std::size_t ray, const flatray::Vec2& origin, const flatray::Vec2& direction,
            std::uint32_t left) override {
    rays_.set(ray, {origin, direction}, {left, flatray::Root::none});
  }

 protected:
  std::string name_, remark_;
  bool exact_;
  std::unique_ptr<flatray::Accelerator> walls_;
  flatray::RayBatch rays_;
  std::vector<flatray::NearestHit> hits_;
};

/// Every wall a mirror: rays in blocks, all one bounce on, then all again.
class Chamber {
 public:
  static constexpr std::size_t kBlock = 1024;
  static constexpr int kBounces = 200;

  Chamber(Tracing& tracing, const Room& room)
      : tracing_(tracing), room_(room), start_(random_rays(kBlock, room.side, 7)) {}
  void run() {
    flatray::RayBatch rays = start_;
    tracing_.take(rays);
    for (int bounce = 0; bounce < kBounces; ++bounce) {
      tracing_.trace();
      for (std::size_t i = 0; i < kBlock; ++i) bounce_ray(rays, i);
    }
  }

 private:
  void bounce_ray(flatray::RayBatch& rays, std::size_t i) {
    const Met met = tracing_.met(i);
    if (met.surface == flatray::kNoSurface) {  // a leak of floats: begin anew
      rays.set(i, start_.ray(i), {});
      return tracing_.turn(i, start_.ray(i).origin, start_.ray(i).direction, met.surface);
    }
    const flatray::Segment& wall = room_.walls.segments[met.surface];
    const flatray::Vec2 along = wall.b - wall.a, normal(along.y(), -along.x());
    const flatray::Ray ray = rays.ray(i);
    const flatray::Vec2 out =
        ray.direction - (2 * ray.direction.dot(normal) / normal.squaredNorm()) * normal;
    rays.set(i, {ray.origin + met.t * ray.direction, out / std::sqrt(out.squaredNorm())}, {});
    tracing_.turn(i, rays.ray(i).origin, rays.ray(i).direction, met.surface);
  }
  Tracing& tracing_;
  const Room& room_;
  flatray::RayBatch start_;
};

}  // namespace bench
