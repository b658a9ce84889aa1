#pragma once
#include <memory>
#include <span>
#include <vector>

#include "anim/world.h"
#include "scene/scatterer.h"
#include "trace/tracer.h"
#include "transport/exact_origin.h"
#include "transport/light/bodies.h"
#include "transport/light/light_ray.h"
#include "transport/light/offset_origins.h"
#include "transport/reflection.h"

namespace flatray {

/// Walls along which rays of a lamp set off: by rounding from one side or the other.
struct WallsBeside {
  std::vector<std::uint32_t> walls;
  double reach = 0;  ///< how far beside them, in each coordinate
};

/// Where a ray of light comes to a wall.
struct LightHit {
  NearestHit hit;
  bool in_corner = false;    ///< of walls, where it ends
  bool from_inside = false;  ///< to the wall of a closed shape: outlines run counter-clockwise
  Vec2 point{0, 0};          ///< of a hit
  Vec2 normal{0, 0};         ///< of length 1, towards the side it comes from; not in a corner
  double offset = 0;         ///< along the normal, to where it goes on from
};

/// The walls of a frame as light meets them, whichever way it is followed: none gets through a closed
/// wall. Rays go on from points beside their walls, or where these are not certain as orbits do
/// (transport/exact_origin.h).
class LitWalls {
 public:
  /// Needs   scatterers by surface, nullptr where its owner's material says all; they and `world`
  ///         outlive it. The tracer of choice where `tracer` is nullptr.
  LitWalls(const World& world, std::span<const Scatterer* const> scatterers, const Tracer* tracer);

  const Surfaces& walls() const { return walls_; }
  /// The walls on which a point stands, ascending. Exact.
  std::vector<std::uint32_t> walls_at(const Vec2& point) const {
    return exact_origins_.walls_at(point);
  }
  const Accelerator& tracer() const { return *tracer_; }
  const Bodies& bodies() const { return bodies_; }

  /// Makes a ray one that has left the wall it stands on, in the bodies it is then in; false where
  /// it cannot set off, from a corner or along a wall.
  /// One that stands beside one of `beside` stands on it, and sets off to the side its direction leads to.
  bool sets_off(LightRay& ray, const WallsBeside& beside = {}) const;
  /// The next wall of each ray. Needs   `met` as long as `rays`.
  void fly(std::span<const LightRay> rays, std::span<LightHit> met) const;
  /// Of a hit in a corner: whether all walls there absorb all light.
  bool all_absorb(const LightRay& ray, const LightHit& met) const;
  /// What a wall is told of light that meets it, not in a corner.
  Arrival arrival(const LightRay& ray, const LightHit& met) const;
  /// What chance, uniform in [0, 1), makes of it.
  Departure depart(const LightHit& met, const Arrival& arrival, double u) const;
  /// Of its scatterer: Scatterer::shares; null where it has none.
  const LightShares* shares(std::uint32_t surface) const {
    return scatterers_[surface] == nullptr ? nullptr : scatterers_[surface]->shares();
  }
  /// From where light goes on behind a wall that it has met.
  bool goes_beyond(Ray& ray, const LightHit& met) const;
  /// Makes `ray`, whose direction is set, one that sets off from where light met a wall; false where it
  /// would run along the wall, or, where it `stays`, to the other side.
  bool sets_off_from(LightRay& ray, const LightHit& met, bool stays) const;
  /// Makes `ray` the one that goes on from where it met a wall; false where it is absorbed, or would run
  /// along the wall.
  bool leaves(LightRay& ray, const LightHit& met, const Departure& departure) const;

 private:
  bool sets_off_beside(LightRay& ray, std::uint32_t surface) const;
  LightHit light_hit(const Ray& ray, const NearestHit& hit) const;
  Sign inside_at(std::uint32_t surface) const;
  Sign side(const LightHit& met) const;
  bool mirrors(Ray& ray, const LightHit& met) const;
  void change_media(LightRay& ray, const LightHit& met) const;

  const Surfaces& walls_;
  const std::vector<SurfaceOwner>& owners_;
  const std::vector<Material> materials_;
  std::span<const Scatterer* const> scatterers_;
  const Bodies bodies_;
  const ExactOrigins exact_origins_;
  const OffsetOrigins offset_origins_;
  const Tracer& kind_;
  const std::unique_ptr<Accelerator> tracer_;
  const Speed speed_{Vec2(1, 0)};
};

}  // namespace flatray
