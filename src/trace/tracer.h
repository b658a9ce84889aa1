#pragma once
#include <span>
#include <string_view>
#include <vector>

#include "trace/hits.h"
#include "trace/rays.h"
#include "trace/surfaces.h"

namespace flatray {

/// One way to find the first wall of many rays. Exact tracers agree bit for bit.
struct Tracer {
  const char* name;
  const char* summary;
  bool exact;  ///< decides for the doubles given, without rounding
  /// Needs   as many hits as rays; finite coordinates. A zero direction asks what the origin lies
  ///         on.
  void (*nearest)(const Surfaces& walls, const RayBatch& rays, std::span<NearestHit> hits);
};

/// Registered tracers by name.
std::vector<const Tracer*> tracers();
/// The tracer called `name`, or nullptr.
const Tracer* find_tracer(std::string_view name);
/// The exact tracer used unless another is asked for.
const Tracer& usual_tracer();

}  // namespace flatray
