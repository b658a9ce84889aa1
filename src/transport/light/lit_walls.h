#pragma once
#include <memory>
#include <span>
#include <vector>

#include "anim/world.h"
#include "scene/scatterer.h"
#include "trace/tracer.h"
#include "transport/landing.h"
#include "transport/light/bodies.h"
#include "transport/light/light_ray.h"
#include "transport/reflection.h"

namespace flatray {

/// Where a ray of light comes to a wall, and where it may go on from.
struct LightLanding {
  NearestHit hit;
  Landing landing;  ///< of a hit
};

/// The walls of a frame as light meets them, whichever way it is followed: rays are those of orbits
/// (transport/orbit.h), so that none gets through a closed wall.
class LitWalls {
 public:
  /// Needs   scatterers by surface, nullptr where its owner's material says all; they and `world`
  ///         outlive it. The tracer of choice where `tracer` is nullptr.
  LitWalls(const World& world, std::span<const Scatterer* const> scatterers, const Tracer* tracer);

  const Surfaces& walls() const { return walls_; }
  const Lander& lander() const { return lander_; }
  const Accelerator& tracer() const { return *tracer_; }
  const Bodies& bodies() const { return bodies_; }

  /// Makes a ray one that has left the wall it stands on, in the bodies it is then in; false where
  /// it cannot set off, from a corner or along a wall.
  bool sets_off(LightRay& ray) const;
  /// The next wall of each ray. Needs   as many landings as rays.
  void fly(std::span<const LightRay> rays, std::span<LightLanding> landings) const;
  /// What a wall is told of light that lands on it, not in a corner.
  Arrival arrival(const LightRay& ray, const LightLanding& landed) const;
  /// What chance, uniform in [0, 1), makes of it.
  Departure depart(const LightLanding& landed, const Arrival& arrival, double u) const;
  /// Whether a landing is in a corner of walls that absorb all light.
  bool all_absorb(std::span<const std::uint32_t> surfaces) const;
  /// Of its scatterer: Scatterer::shares; null where it has none.
  const LightShares* shares(std::uint32_t surface) const {
    return scatterers_[surface] == nullptr ? nullptr : scatterers_[surface]->shares();
  }
  /// Makes `ray`, whose direction is set, one that sets off from where `came` landed; false where it
  /// would run along the wall, or, where it `stays`, to the other side.
  bool sets_off_from(LightRay& ray, const Ray& came, const LightLanding& landed, bool stays) const;
  /// Makes `ray` the one that goes on from where it landed; false where it is absorbed, or would run
  /// along the wall.
  bool leaves(LightRay& ray, const LightLanding& landed, const Departure& departure) const;

 private:
  void change_media(LightRay& ray, std::uint32_t surface, bool was_inside) const;

  const Surfaces& walls_;
  const std::vector<Material> materials_;
  std::span<const Scatterer* const> scatterers_;
  const Bodies bodies_;
  const Lander lander_;
  const std::unique_ptr<Accelerator> tracer_;
  const Speed speed_{Vec2(1, 0)};
};

}  // namespace flatray
