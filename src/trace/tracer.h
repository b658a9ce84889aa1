#pragma once
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/isa.h"
#include "trace/hits.h"
#include "trace/rays.h"
#include "trace/surfaces.h"

namespace flatray {

/// Walls made ready for one tracer, once for any number of rays and threads.
class Accelerator {
 public:
  /// Needs   `walls` to outlive it, and to stay as they are.
  explicit Accelerator(const Surfaces& walls) : walls_(walls) {}
  virtual ~Accelerator() = default;
  Accelerator(const Accelerator&) = delete;
  Accelerator& operator=(const Accelerator&) = delete;

  /// The first wall of each ray. A derived class overrides this or nearest_of_one(), of which each
  /// calls the other.
  ///
  /// Needs   as many hits as rays; finite coordinates. A zero direction asks what the origin lies
  ///         on.
  virtual void nearest(const RayBatch& rays, std::span<NearestHit> hits) const;
  /// The first wall of one ray, on which the lanes of a batch would be wasted.
  virtual NearestHit nearest_of_one(const Ray& ray, const DepartedSurface& departed = {},
                                    bool tangents = true) const;
  /// How many walls are looked at to find the first of one ray, where one looked at twice counts
  /// twice; divided by the number of walls it is the measure of the paper. It counts the search in
  /// double precision; lanes look at a few more.
  virtual std::size_t tested_of_one(const Ray& ray, const DepartedSurface& departed = {}) const;
  /// How many rays are decided one by one, as lanes could not be certain: all, where there are no
  /// lanes. For statistics; costs what the lanes do.
  virtual std::size_t left_by_lanes(const RayBatch& rays) const { return rays.size(); }
  /// Whether each ray meets a wall at t <= `up_to`: 1 or 0.
  ///
  /// Needs   as many of both as rays.
  /// Gives   of exact tracers the exact answer, also where t rounds to `up_to`.
  virtual void any(const RayBatch& rays, std::span<const double> up_to,
                   std::span<std::uint8_t> met) const;
  bool any_of_one(const Ray& ray, double up_to, const DepartedSurface& departed = {},
                  bool tangents = true) const;
  /// Every wall a ray meets, in order of t, those met together by number.
  ///
  /// Gives   a wall along which the ray runs once, a curve once for each point met. A wall just
  ///         left is not met, as in nearest(). Every tracer gives the exact hits.
  /// Cost    some us, and 1 us a hit.
  virtual std::vector<NearestHit> all_of_one(const Ray& ray, const DepartedSurface& departed = {},
                                             bool tangents = true) const;
  /// Bytes that it holds besides the walls themselves.
  virtual std::size_t bytes() const = 0;
  /// How the walls are kept, in words, and how many cells that makes: 0 where all is in lists.
  virtual std::string structure() const { return "one list"; }
  virtual std::size_t cells() const { return 0; }

 protected:
  const Surfaces& walls_;
};

/// One way to find the first wall of many rays. Exact tracers agree bit for bit.
struct Tracer {
  const char* name;
  const char* summary;
  bool exact;  ///< decides for the doubles given, without rounding
  std::unique_ptr<Accelerator> (*build_for)(const Surfaces& walls, Isa isa, unsigned threads);
  /// Why it cannot be used on this machine, "" where it can; null: it always can.
  std::string (*missing)() = nullptr;

  /// Needs   `walls` to outlive what is built, and to stay as they are.
  /// Gives   the same hits in every tier, for any number of threads that build.
  std::unique_ptr<Accelerator> build(const Surfaces& walls, Isa isa = active_isa(),
                                     unsigned threads = 1) const {
    return build_for(walls, isa, threads);
  }
};

/// Registered tracers by name.
std::vector<const Tracer*> tracers();
/// The tracer called `name`, or nullptr.
const Tracer* find_tracer(std::string_view name);
/// An exact tracer, and why it.
struct TracerChoice {
  const Tracer* tracer;
  std::string reason;
};
/// The tracer that is asked for; without one the exact one that measured fastest for as many walls
/// (docs/adr/0010-tracers.md).
TracerChoice choose_tracer(const Surfaces& walls, const Tracer* asked = nullptr);
/// Walls made ready for the tracer of choice, in the tier this machine uses.
std::unique_ptr<Accelerator> accelerate(const Surfaces& walls, unsigned threads = 1);

}  // namespace flatray
