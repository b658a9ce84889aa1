#pragma once
#include <memory>
#include <string>
#include <vector>

#include "trace/rays.h"
#include "trace/surfaces.h"

namespace bench {

/// What a ray meets first.
struct Met {
  std::uint32_t surface;
  double t;
};

/// One way to find what many rays meet first among the walls of a scene.
class Tracing {
 public:
  virtual ~Tracing() = default;
  virtual std::string name() const = 0;
  /// Whose formulas, in which numbers, decide what a ray meets; in a few letters.
  virtual std::string arithmetic() const = 0;
  /// Of what it was built from the walls, in words; may be empty.
  virtual std::string remark() const { return {}; }
  /// Whether it is worth trying in a chamber: rays there have nothing in common.
  virtual bool for_chambers() const { return true; }
  /// Takes the rays in; not timed. Directions are of unit length.
  virtual void take(const flatray::RayBatch& rays) = 0;
  /// Answers for the rays taken; timed.
  virtual void trace() = 0;
  virtual Met met(std::size_t ray) const = 0;
  /// Sends ray i on from `origin` on the wall `left`: what a chamber does after every bounce.
  virtual void turn(std::size_t ray, const flatray::Vec2& origin, const flatray::Vec2& direction,
                    std::uint32_t left) = 0;
};

using Tracings = std::vector<std::unique_ptr<Tracing>>;

/// Appended by the libraries built in: peers/.
void add_embree(const flatray::Surfaces& walls, double depth, Tracings& all);

}  // namespace bench
