// Embree 3: a segment is a quad through z in [-depth, depth], rays lie in z = 0.
#include <embree3/rtcore.h>

#include <algorithm>
#include <limits>

#include "tracing.h"

namespace bench {
namespace {

constexpr float kNever = std::numeric_limits<float>::infinity();

class Scene {
 public:
  Scene(const flatray::Surfaces& walls, double depth)
      : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
    RTCGeometry quads = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_QUAD);
    const std::size_t count = walls.segments.size();
    auto* corner = static_cast<float*>(rtcSetNewGeometryBuffer(
        quads, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 4 * count));
    auto* index = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        quads, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT4, 4 * sizeof(std::uint32_t), count));
    const auto z = static_cast<float>(depth);
    for (std::size_t i = 0; i < count; ++i) {
      const flatray::Segment& s = walls.segments[i];
      const auto put = [&](const flatray::Vec2& p, float height) {
        *corner++ = static_cast<float>(p.x());
        *corner++ = static_cast<float>(p.y());
        *corner++ = height;
      };
      put(s.a, -z);
      put(s.b, -z);
      put(s.b, z);
      put(s.a, z);
      for (std::uint32_t k = 0; k < 4; ++k)
        index[4 * i + k] = static_cast<std::uint32_t>(4 * i) + k;
    }
    rtcSetGeometryBuildQuality(quads, RTC_BUILD_QUALITY_HIGH);
    rtcCommitGeometry(quads);
    rtcAttachGeometry(scene_, quads);
    rtcReleaseGeometry(quads);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
    rtcCommitScene(scene_);
  }
  ~Scene() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;
  RTCScene get() const { return scene_; }

 private:
  RTCDevice device_;
  RTCScene scene_;
};

struct Columns {
  std::vector<float> ox, oy, dx, dy, near, t;
  std::vector<std::uint32_t> surface;
  void resize(std::size_t count) {
    for (std::vector<float>* column : {&ox, &oy, &dx, &dy, &near, &t}) column->resize(count);
    surface.resize(count);
  }
};

void load(const Columns& rays, std::size_t i, RTCRayHit& r) {
  r.ray = {rays.ox[i], rays.oy[i], 0,      rays.near[i], rays.dx[i], rays.dy[i],
           0,          0,          kNever, ~0U,          0,          0};
  r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  r.hit.primID = RTC_INVALID_GEOMETRY_ID;
  r.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
}

void trace_1(RTCScene scene, Columns& rays) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  for (std::size_t i = 0; i < rays.ox.size(); ++i) {
    RTCRayHit r;
    load(rays, i, r);
    rtcIntersect1(scene, &context, &r);
    rays.t[i] = r.ray.tfar;
    rays.surface[i] = r.hit.primID;
  }
}

template <RTCIntersectContextFlags flags>
void trace_16(RTCScene scene, Columns& rays) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = flags;
  alignas(64) RTCRayHit16 r{};
  alignas(64) int valid[16];
  std::fill(std::begin(r.ray.mask), std::end(r.ray.mask), ~0U);
  for (std::size_t i = 0; i < rays.ox.size(); i += 16) {
    const std::size_t count = std::min<std::size_t>(16, rays.ox.size() - i);
    for (std::size_t k = 0; k < 16; ++k) valid[k] = k < count ? -1 : 0;
    const auto copy = [&](const std::vector<float>& from, float* to) {
      std::copy_n(from.data() + i, count, to);
    };
    copy(rays.ox, r.ray.org_x);
    copy(rays.oy, r.ray.org_y);
    copy(rays.dx, r.ray.dir_x);
    copy(rays.dy, r.ray.dir_y);
    copy(rays.near, r.ray.tnear);
    std::fill(std::begin(r.ray.tfar), std::end(r.ray.tfar), kNever);
    std::fill(std::begin(r.hit.geomID), std::end(r.hit.geomID), RTC_INVALID_GEOMETRY_ID);
    std::fill(std::begin(r.hit.primID), std::end(r.hit.primID), RTC_INVALID_GEOMETRY_ID);
    rtcIntersect16(valid, scene, &context, &r);
    std::copy_n(r.ray.tfar, count, rays.t.data() + i);
    std::copy_n(r.hit.primID, count, rays.surface.data() + i);
  }
}

class Embree : public Tracing {
 public:
  Embree(std::string name, bool for_chambers, std::shared_ptr<Scene> scene,
         void (*run)(RTCScene, Columns&))
      : name_(std::move(name)), for_chambers_(for_chambers), scene_(std::move(scene)), run_(run) {}
  std::string name() const override { return name_; }
  bool for_chambers() const override { return for_chambers_; }
  void take(const flatray::RayBatch& rays) override {
    rays_.resize(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
      put(i, rays.ray(i).origin, rays.ray(i).direction);
      rays_.near[i] = 0;
    }
  }
  void trace() override { run_(scene_->get(), rays_); }
  Met met(std::size_t ray) const override {
    return {rays_.surface[ray], static_cast<double>(rays_.t[ray])};
  }
  void turn(std::size_t ray, const flatray::Vec2& origin, const flatray::Vec2& direction,
            std::uint32_t) override {
    put(ray, origin, direction);
    rays_.near[ray] = 2e-5F * std::max(1.0F, std::max(rays_.ox[ray], rays_.oy[ray]));
  }

 private:
  void put(std::size_t i, const flatray::Vec2& origin, const flatray::Vec2& direction) {
    rays_.ox[i] = static_cast<float>(origin.x());
    rays_.oy[i] = static_cast<float>(origin.y());
    rays_.dx[i] = static_cast<float>(direction.x());
    rays_.dy[i] = static_cast<float>(direction.y());
  }
  std::string name_;
  bool for_chambers_;
  std::shared_ptr<Scene> scene_;
  void (*run_)(RTCScene, Columns&);
  Columns rays_;
};

}  // namespace

void add_embree(const flatray::Surfaces& walls, double depth, Tracings& all) {
  const auto scene = std::make_shared<Scene>(walls, depth);
  const auto add = [&](const char* name, bool for_chambers, void (*run)(RTCScene, Columns&)) {
    all.push_back(std::make_unique<Embree>(name, for_chambers, scene, run));
  };
  add("Embree, 1", true, &trace_1);
  add("Embree, 16", true, &trace_16<RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT>);
  add("Embree, 16 coherent", false, &trace_16<RTC_INTERSECT_CONTEXT_FLAG_COHERENT>);
}

}  // namespace bench
