#pragma once
#include <memory>
#include <span>

#include "transport/exact_origin.h"
#include "transport/glass.h"
#include "transport/orbit.h"
#include "transport/periodic_walls.h"

namespace flatray {

/// Where a ray sets off.
struct OrbitStart {
  Ray ray;
  /// What it has just left; without a surface the walls it starts on are looked for.
  DepartedSurface departed{};
  /// Seeds what chance decides at glass: chance_of_orbit().
  std::uint64_t chance = 0;
};

/// Sees orbits as they are made, so that long ones need no memory.
class OrbitSink {
 public:
  virtual ~OrbitSink() = default;
  /// Orbit `number` was reflected, or refracted; its bounces come in order, those of other orbits in between.
  virtual void bounce(std::size_t number, const Bounce& bounce) = 0;
  /// Orbit `number` left by a periodic wall and goes on from that opposite.
  virtual void cross(std::size_t, const Vec2& /*from*/, const Vec2& /*to*/,
                     const CellIndex& /*step*/) {}
  virtual void end(std::size_t, const OrbitStop& /*stop*/) {}
};

/// Walls made ready to follow orbits among them, once for any number of orbits and threads.
class OrbitTracer {
 public:
  /// Needs   `walls` and `materials`, by surface, to outlive it.
  OrbitTracer(const Surfaces& walls, std::span<const Material> materials,
              const OrbitRules& rules = {});

  /// Follows many orbits together, so that the tracer of walls gets them in batches. What each does
  /// is as trace_orbit says and does not depend on the others.
  ///
  /// Needs   directions that are not zero.
  void follow(std::span<const OrbitStart> starts, std::uint64_t bounces, OrbitSink& sink) const;

  /// What was built: what finds the walls, and why it; what knows the walls near an origin.
  const TracerChoice& choice() const { return choice_; }
  const Accelerator& walls() const { return *tracer_; }
  /// What it was built of.
  const Surfaces& surfaces() const { return walls_; }
  std::span<const Material> materials() const { return materials_; }
  const WallCells& origin_cells() const { return origins_.cells(); }
  const PeriodicWalls& periodic() const { return periodic_; }
  double field() const { return field_; }
  bool has_glass() const { return glass_ != nullptr; }

 private:
  struct Flight;
  class Wave;

  const Surfaces& walls_;
  std::span<const Material> materials_;
  CornerRule corners_;
  double field_;
  const Glass* glass_;   ///< where there is any
  TracerChoice choice_;  ///< of one that is not exact what it finds may not be there
  ExactOrigins origins_;
  std::unique_ptr<Accelerator> tracer_;
  PeriodicWalls periodic_;
};

/// The orbits of many starts among walls made ready before.
std::vector<Orbit> trace_orbits(const OrbitTracer& tracer, std::span<const OrbitStart> starts,
                                std::uint64_t bounces);
/// The orbits of many rays among walls made ready before: what trace_orbits gives.
std::vector<Orbit> trace_orbits(const OrbitTracer& tracer, std::span<const Ray> starts,
                                std::uint64_t bounces);

}  // namespace flatray
