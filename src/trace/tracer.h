#pragma once
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "trace/hits.h"
#include "trace/rays.h"
#include "trace/surfaces.h"

namespace flatray {

/// Walls made ready for one tracer, once for any number of rays and threads.
class Accelerator {
 public:
  virtual ~Accelerator() = default;
  /// The first wall of each ray.
  ///
  /// Needs   as many hits as rays; finite coordinates. A zero direction asks what the origin lies
  ///         on.
  virtual void nearest(const RayBatch& rays, std::span<NearestHit> hits) const = 0;
  /// What it holds beside the walls themselves.
  virtual std::size_t bytes() const = 0;
};

/// One way to find the first wall of many rays. Exact tracers agree bit for bit.
struct Tracer {
  const char* name;
  const char* summary;
  bool exact;  ///< decides for the doubles given, without rounding
  /// Needs   `walls` to outlive what is built, and to stay as they are.
  std::unique_ptr<Accelerator> (*build)(const Surfaces& walls);
};

/// Registered tracers by name.
std::vector<const Tracer*> tracers();
/// The tracer called `name`, or nullptr.
const Tracer* find_tracer(std::string_view name);
/// The exact tracer used unless another is asked for.
const Tracer& usual_tracer();

}  // namespace flatray
