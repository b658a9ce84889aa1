// Embree 4 or 3, single rays and packets of 8 and 16. A segment is a quad through z in [-depth, depth], rays
// lie in z = 0. Embree has no formula for a circle in a plane: circles and parts of them are user geometry, found by
// its tree and met by the textbook's formula in floats, a part where the point is on the side of its chord. Bezier curves
// it does not know.
#if FLATRAY_EMBREE_MAJOR == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <cmath>
#include <limits>

#include "tracing.h"

namespace bench {
namespace {

constexpr float kNever = std::numeric_limits<float>::infinity();
enum GeometryId : unsigned { kSegments, kCircles };

// A circle, or the part of it that lies where (point - centre) . middle >= cut; its box.
struct Disc {
  float x, y, radius, middle_x, middle_y, cut, low_x, low_y, high_x, high_y;
};
Disc disc_of(const flatray::Arc& arc) {
  using flatray::Vec2;
  const Vec2& centre = arc.curve.centre;
  const double r = arc.curve.u.x();
  const bool is_whole = arc.extent == flatray::Arc::Extent::whole;
  const Vec2 chord = is_whole ? Vec2(0, 1) : Vec2((arc.to - arc.from).normalized());
  const Vec2 middle(chord.y(), -chord.x());
  const double cut = is_whole ? -2 * r : middle.dot(arc.from - centre);
  flatray::Bounds box;
  if (!is_whole) {
    box.add(arc.from);
    box.add(arc.to);
  }
  for (const Vec2& pole : {Vec2(r, 0), Vec2(0, r), Vec2(-r, 0), Vec2(0, -r)})
    if (middle.dot(pole) >= cut) box.add(centre + pole);
  const Vec2 off = Vec2::Constant(1e-6 * (centre.cwiseAbs().sum() + r));
  const Vec2 low = box.low - off, high = box.high + off;
  const auto single = [](double x) { return static_cast<float>(x); };
  return {single(centre.x()), single(centre.y()), single(r),       single(middle.x()),
          single(middle.y()), single(cut),        single(low.x()), single(low.y()),
          single(high.x()),   single(high.y())};
}

void bound(const RTCBoundsFunctionArguments* arguments) {
  const Disc& disc = static_cast<const Disc*>(arguments->geometryUserPtr)[arguments->primID];
  RTCBounds& box = *arguments->bounds_o;
  box.lower_x = disc.low_x, box.lower_y = disc.low_y, box.lower_z = -disc.radius;
  box.upper_x = disc.high_x, box.upper_y = disc.high_y, box.upper_z = disc.radius;
}

// Rays are of unit length.
void meet(const RTCIntersectFunctionNArguments* arguments) {
  const Disc& disc = static_cast<const Disc*>(arguments->geometryUserPtr)[arguments->primID];
  const unsigned count = arguments->N;
  RTCRayN* rays = RTCRayHitN_RayN(arguments->rayhit, count);
  RTCHitN* hits = RTCRayHitN_HitN(arguments->rayhit, count);
  for (unsigned i = 0; i < count; ++i) {
    if (arguments->valid[i] == 0) continue;
    const float wx = RTCRayN_org_x(rays, count, i) - disc.x;
    const float wy = RTCRayN_org_y(rays, count, i) - disc.y;
    const float dx = RTCRayN_dir_x(rays, count, i), dy = RTCRayN_dir_y(rays, count, i);
    const float b = dx * wx + dy * wy;
    const float root = std::sqrt(b * b - (wx * wx + wy * wy - disc.radius * disc.radius));
    const float near = RTCRayN_tnear(rays, count, i);
    const auto is_met = [&](float t) {
      return t >= near && t < RTCRayN_tfar(rays, count, i) &&
             (wx + t * dx) * disc.middle_x + (wy + t * dy) * disc.middle_y >= disc.cut;
    };
    float t = -b - root;
    if (!is_met(t)) t = -b + root;
    if (!is_met(t)) continue;
    RTCRayN_tfar(rays, count, i) = t;
    RTCHitN_primID(hits, count, i) = arguments->primID;
    RTCHitN_geomID(hits, count, i) = arguments->geomID;
  }
}

class Scene {
 public:
  Scene(const flatray::Surfaces& walls, double depth)
      : device_(rtcNewDevice("threads=1")),
        scene_(rtcNewScene(device_)),
        segment_numbers_(walls.segment_numbers),
        circle_numbers_(walls.curve_numbers) {
    if (!walls.segments.empty()) attach(quads(walls, static_cast<float>(depth)), kSegments);
    for (const flatray::Arc& arc : walls.arcs) discs_.push_back(disc_of(arc));  // of circles
    if (!discs_.empty()) attach(circles(), kCircles);
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
  bool has_circles() const { return !discs_.empty(); }
  std::uint32_t surface(unsigned geometry, unsigned primitive) const {
    return geometry == RTC_INVALID_GEOMETRY_ID ? flatray::kNoSurface
           : geometry == kSegments             ? segment_numbers_[primitive]
                                               : circle_numbers_[primitive];
  }

 private:
  RTCGeometry quads(const flatray::Surfaces& walls, float z) const {
    RTCGeometry made = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_QUAD);
    const std::size_t count = walls.segments.size();
    auto* corner = static_cast<float*>(rtcSetNewGeometryBuffer(
        made, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 4 * count));
    auto* index = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        made, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT4, 4 * sizeof(std::uint32_t), count));
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
    return made;
  }
  RTCGeometry circles() {
    RTCGeometry made = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(made, static_cast<unsigned>(discs_.size()));
    rtcSetGeometryUserData(made, discs_.data());
    rtcSetGeometryBoundsFunction(made, &bound, nullptr);
    rtcSetGeometryIntersectFunction(made, &meet);
    return made;
  }
  void attach(RTCGeometry geometry, GeometryId id) {
    rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene_, geometry, id);
    rtcReleaseGeometry(geometry);
  }

  RTCDevice device_;
  RTCScene scene_;
  std::vector<std::uint32_t> segment_numbers_, circle_numbers_;
  std::vector<Disc> discs_;
};

struct Columns {
  std::vector<float> ox, oy, dx, dy, near, t;
  std::vector<unsigned> geometry, primitive;
  void resize(std::size_t count) {
    for (std::vector<float>* column : {&ox, &oy, &dx, &dy, &near, &t}) column->resize(count);
    geometry.resize(count);
    primitive.resize(count);
  }
};

// What differs between the versions: how a call is told of its rays.
#if FLATRAY_EMBREE_MAJOR == 4
struct Call {
  RTCIntersectArguments arguments;
  explicit Call(bool coherent) {
    rtcInitIntersectArguments(&arguments);
    arguments.flags = coherent ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
  }
  void operator()(const int*, RTCScene scene, RTCRayHit& r) {
    rtcIntersect1(scene, &r, &arguments);
  }
  void operator()(const int* valid, RTCScene scene, RTCRayHit8& r) {
    rtcIntersect8(valid, scene, &r, &arguments);
  }
  void operator()(const int* valid, RTCScene scene, RTCRayHit16& r) {
    rtcIntersect16(valid, scene, &r, &arguments);
  }
};
#else
struct Call {
  RTCIntersectContext context;
  explicit Call(bool coherent) {
    rtcInitIntersectContext(&context);
    context.flags =
        coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  }
  void operator()(const int*, RTCScene scene, RTCRayHit& r) { rtcIntersect1(scene, &context, &r); }
  void operator()(const int* valid, RTCScene scene, RTCRayHit8& r) {
    rtcIntersect8(valid, scene, &context, &r);
  }
  void operator()(const int* valid, RTCScene scene, RTCRayHit16& r) {
    rtcIntersect16(valid, scene, &context, &r);
  }
};
#endif

void trace_1(RTCScene scene, Columns& rays) {
  Call intersect(false);
  for (std::size_t i = 0; i < rays.ox.size(); ++i) {
    RTCRayHit r;
    r.ray = {rays.ox[i], rays.oy[i], 0,      rays.near[i], rays.dx[i], rays.dy[i],
             0,          0,          kNever, ~0U,          0,          0};
    r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    r.hit.primID = RTC_INVALID_GEOMETRY_ID;
    r.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    intersect(nullptr, scene, r);
    rays.t[i] = r.ray.tfar;
    rays.geometry[i] = r.hit.geomID;
    rays.primitive[i] = r.hit.primID;
  }
}

template <class Packet, std::size_t width, bool coherent>
void trace_packets(RTCScene scene, Columns& rays) {
  Call intersect(coherent);
  alignas(64) Packet r{};
  alignas(64) int valid[width];
  std::fill(std::begin(r.ray.mask), std::end(r.ray.mask), ~0U);
  for (std::size_t i = 0; i < rays.ox.size(); i += width) {
    const std::size_t count = std::min(width, rays.ox.size() - i);
    for (std::size_t k = 0; k < width; ++k) valid[k] = k < count ? -1 : 0;
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
    intersect(valid, scene, r);
    std::copy_n(r.ray.tfar, count, rays.t.data() + i);
    std::copy_n(r.hit.geomID, count, rays.geometry.data() + i);
    std::copy_n(r.hit.primID, count, rays.primitive.data() + i);
  }
}

class Embree : public Tracing {
 public:
  Embree(std::string name, bool for_chambers, std::shared_ptr<Scene> scene,
         void (*run)(RTCScene, Columns&))
      : name_(std::move(name)), for_chambers_(for_chambers), scene_(std::move(scene)), run_(run) {}
  std::string name() const override { return name_; }
  std::string arithmetic() const override {
    return scene_->has_circles() ? "Embree, ours" : "Embree";
  }
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
    return {scene_->surface(rays_.geometry[ray], rays_.primitive[ray]),
            static_cast<double>(rays_.t[ray])};
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
  add("Embree, 8", true, &trace_packets<RTCRayHit8, 8, false>);
  add("Embree, 16", true, &trace_packets<RTCRayHit16, 16, false>);
  add("Embree, 8 coherent", false, &trace_packets<RTCRayHit8, 8, true>);
  add("Embree, 16 coherent", false, &trace_packets<RTCRayHit16, 16, true>);
}

}  // namespace bench
