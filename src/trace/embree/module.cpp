// The module: Embree 3 or 4, as configure found it. A segment is a quad across z = 0, in which rays
// lie; the wall just left is left out by a filter, so that no distance is involved. Curves are user
// geometry: Embree finds whose boxes a ray passes, the tracer says whether it meets them.
#include "trace/embree/module.h"

#if FLATRAY_EMBREE_MAJOR == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

struct FlatrayEmbreeScene {
  RTCDevice device;
  RTCScene scene;
};

namespace {

#if FLATRAY_EMBREE_MAJOR == 4
using Context = RTCRayQueryContext;
#else
using Context = RTCIntersectContext;
#endif

constexpr unsigned kNone = 0xffffffffU;
enum GeometryId : unsigned { kSegments, kCurves };

struct Query {
  Context context;  // first: what the callbacks are given
  unsigned departed;
  const FlatrayEmbreeAsker* asker;
};

void leave_out(const RTCFilterFunctionNArguments* arguments) {
  const auto* query = reinterpret_cast<const Query*>(arguments->context);
  for (unsigned i = 0; i < arguments->N; ++i)
    if (RTCHitN_primID(arguments->hit, arguments->N, i) == query->departed) arguments->valid[i] = 0;
}

// Whether Embree gave it the memory.
bool fill(RTCGeometry quads, const double* ends, unsigned count) {
  auto* corner = static_cast<float*>(rtcSetNewGeometryBuffer(quads, RTC_BUFFER_TYPE_VERTEX, 0,
                                                             RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                             std::size_t{4} * count));
  auto* index = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      quads, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT4, 4 * sizeof(unsigned), count));
  if (corner == nullptr || index == nullptr) return false;
  double size = 0;
  for (unsigned i = 0; i < 4 * count; ++i) size = std::max(size, std::fabs(ends[i]));
  const auto depth = static_cast<float>(size / 64);
  for (unsigned i = 0; i < count; ++i) {
    const double* end = ends + std::size_t{4} * i;
    const auto put = [&](const double* point, float z) {
      *corner++ = static_cast<float>(point[0]);
      *corner++ = static_cast<float>(point[1]);
      *corner++ = z;
    };
    put(end, -depth);
    put(end + 2, -depth);
    put(end + 2, depth);
    put(end, depth);
    for (unsigned k = 0; k < 4; ++k) *index++ = 4 * i + k;
  }
  return true;
}

void bound(const RTCBoundsFunctionArguments* arguments) {
  const auto& walls = *static_cast<const FlatrayEmbreeWalls*>(arguments->geometryUserPtr);
  const FlatrayEmbreeBox& box = walls.curves[arguments->primID];
  const float depth = std::max(1.0F, std::max(box.high_x - box.low_x, box.high_y - box.low_y));
  RTCBounds& bounds = *arguments->bounds_o;
  bounds.lower_x = box.low_x, bounds.lower_y = box.low_y, bounds.lower_z = -depth;
  bounds.upper_x = box.high_x, bounds.upper_y = box.high_y, bounds.upper_z = depth;
}

void meet(const RTCIntersectFunctionNArguments* arguments) {
  const FlatrayEmbreeAsker& asker = *reinterpret_cast<const Query*>(arguments->context)->asker;
  RTCRayN* rays = RTCRayHitN_RayN(arguments->rayhit, arguments->N);
  RTCHitN* hits = RTCRayHitN_HitN(arguments->rayhit, arguments->N);
  for (unsigned i = 0; i < arguments->N; ++i) {
    const unsigned ray = RTCRayN_id(rays, arguments->N, i);
    if (arguments->valid[i] == 0 ||
        !asker.meets(asker.asker, ray, arguments->primID, &RTCRayN_tfar(rays, arguments->N, i)))
      continue;
    RTCHitN_primID(hits, arguments->N, i) = arguments->primID;
    RTCHitN_geomID(hits, arguments->N, i) = arguments->geomID;
  }
}

void attach(RTCScene scene, RTCGeometry geometry, GeometryId id) {
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, id);
}

// Null where Embree fails; the device then says why.
RTCScene make_scene(RTCDevice device, const FlatrayEmbreeWalls& walls) {
  RTCScene scene = rtcNewScene(device);
  if (scene == nullptr) return nullptr;
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST
#if FLATRAY_EMBREE_MAJOR == 3
                              | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION
#endif
  );
  if (walls.segments > 0) {
    RTCGeometry quads = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_QUAD);
    if (quads != nullptr && fill(quads, walls.ends, walls.segments)) {
      rtcSetGeometryIntersectFilterFunction(quads, &leave_out);
      attach(scene, quads, kSegments);
    }
    if (quads != nullptr) rtcReleaseGeometry(quads);
  }
  if (walls.curve_count > 0) {
    RTCGeometry curves = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    if (curves != nullptr) {
      rtcSetGeometryUserPrimitiveCount(curves, walls.curve_count);
      rtcSetGeometryUserData(curves, const_cast<FlatrayEmbreeWalls*>(&walls));
      rtcSetGeometryBoundsFunction(curves, &bound, nullptr);
      rtcSetGeometryIntersectFunction(curves, &meet);
      attach(scene, curves, kCurves);
      rtcReleaseGeometry(curves);
    }
  }
  rtcCommitScene(scene);  // asks for the boxes, now and no more
  return scene;
}

FlatrayEmbreeScene* build(const FlatrayEmbreeWalls* walls, bool* out_of_memory) {
  RTCDevice device = rtcNewDevice("threads=1");
  RTCScene scene = device == nullptr ? nullptr : make_scene(device, *walls);
  const RTCError error = rtcGetDeviceError(device);  // of no device: of this thread
  auto* made =
      error == RTC_ERROR_NONE ? new (std::nothrow) FlatrayEmbreeScene{device, scene} : nullptr;
  if (made != nullptr) return made;
  // It needs memory to keep an error, and says UNKNOWN or INVALID where it has none.
  *out_of_memory = error != RTC_ERROR_UNSUPPORTED_CPU;
  if (scene != nullptr) rtcReleaseScene(scene);
  if (device != nullptr) rtcReleaseDevice(device);
  return nullptr;
}

void release(FlatrayEmbreeScene* scene) {
  rtcReleaseScene(scene->scene);
  rtcReleaseDevice(scene->device);
  delete scene;
}

// What Embree takes: with more it stops the program, where it was built with its checks.
bool is_valid(const FlatrayEmbreeRay& ray) {
  constexpr float kLargest = 1.844e18F;
  for (const float number : {ray.ox, ray.oy, ray.dx, ray.dy})
    if (!(std::fabs(number) <= kLargest)) return false;
  return true;
}

void nearest(const FlatrayEmbreeScene* scene, const FlatrayEmbreeRay* rays, unsigned count,
             const FlatrayEmbreeAsker* asker, FlatrayEmbreeHit* hits) {
  constexpr float kNever = std::numeric_limits<float>::infinity();
  Query query{};
  query.asker = asker;
#if FLATRAY_EMBREE_MAJOR == 4
  rtcInitRayQueryContext(&query.context);
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &query.context;
#else
  rtcInitIntersectContext(&query.context);
#endif
  for (unsigned i = 0; i < count; ++i) {
    const FlatrayEmbreeRay& ray = rays[i];
    if (!is_valid(ray)) {
      hits[i] = {kNever, kNone, false};
      continue;
    }
    RTCRayHit r{};
    r.ray = {ray.ox, ray.oy, 0, 0, ray.dx, ray.dy, 0, 0, kNever, ~0U, i, 0};
    r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    r.hit.primID = RTC_INVALID_GEOMETRY_ID;
    query.departed = ray.departed;
#if FLATRAY_EMBREE_MAJOR == 4
    rtcIntersect1(scene->scene, &r, &arguments);
#else
    rtcIntersect1(scene->scene, &query.context, &r);
#endif
    const bool met = r.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    hits[i] = {r.ray.tfar, met ? r.hit.primID : kNone, r.hit.geomID == kCurves};
  }
}

constexpr FlatrayEmbreeModule kModule = {FLATRAY_EMBREE_ABI, RTC_VERSION_STRING, &build, &release,
                                         &nearest};

}  // namespace

extern "C" __attribute__((visibility("default"))) const FlatrayEmbreeModule*
flatray_embree_module() {
  return &kModule;
}
