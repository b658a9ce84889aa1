// The module: Embree 3 or 4, as configure found it. A segment is a quad across z = 0, in which rays
// lie; the wall just left is left out by a filter, so that no distance is involved.
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

struct Query {
  Context context;  // first: what the filter is given
  unsigned left;
};

void leave_out(const RTCFilterFunctionNArguments* arguments) {
  const auto* query = reinterpret_cast<const Query*>(arguments->context);
  for (unsigned i = 0; i < arguments->N; ++i)
    if (RTCHitN_primID(arguments->hit, arguments->N, i) == query->left) arguments->valid[i] = 0;
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

// Null where Embree fails; the device then says why.
RTCScene make_scene(RTCDevice device, const double* ends, unsigned count) {
  RTCScene scene = rtcNewScene(device);
  if (scene == nullptr) return nullptr;
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST
#if FLATRAY_EMBREE_MAJOR == 3
                              | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION
#endif
  );
  if (count > 0) {
    RTCGeometry quads = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_QUAD);
    if (quads != nullptr && fill(quads, ends, count)) {
      rtcSetGeometryIntersectFilterFunction(quads, &leave_out);
      rtcCommitGeometry(quads);
      rtcAttachGeometry(scene, quads);
    }
    if (quads != nullptr) rtcReleaseGeometry(quads);
  }
  rtcCommitScene(scene);
  return scene;
}

FlatrayEmbreeScene* build(const double* ends, unsigned count, bool* out_of_memory) {
  RTCDevice device = rtcNewDevice("threads=1");
  RTCScene scene = device == nullptr ? nullptr : make_scene(device, ends, count);
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
             FlatrayEmbreeHit* hits) {
  constexpr float kNever = std::numeric_limits<float>::infinity();
  Query query{};
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
      hits[i] = {kNever, 0xffffffffU};
      continue;
    }
    RTCRayHit r{};
    r.ray = {ray.ox, ray.oy, 0, 0, ray.dx, ray.dy, 0, 0, kNever, ~0U, 0, 0};
    r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    r.hit.primID = RTC_INVALID_GEOMETRY_ID;
    query.left = ray.left;
#if FLATRAY_EMBREE_MAJOR == 4
    rtcIntersect1(scene->scene, &r, &arguments);
#else
    rtcIntersect1(scene->scene, &query.context, &r);
#endif
    const bool met = r.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    hits[i] = {r.ray.tfar, met ? r.hit.primID : 0xffffffffU};
  }
}

constexpr FlatrayEmbreeModule kModule = {FLATRAY_EMBREE_ABI, RTC_VERSION_STRING, &build, &release,
                                         &nearest};

}  // namespace

extern "C" __attribute__((visibility("default"))) const FlatrayEmbreeModule*
flatray_embree_module() {
  return &kModule;
}
