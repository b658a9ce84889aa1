#pragma once
#include <vector>

#include "transport/light/bodies.h"

namespace flatray {

/// Bodies of glass in a world, at whose walls chance reflects or refracts an orbit, with the parts that Fresnel's
/// equations give (geom/refract.h): ray splitting.
///
/// Source  Couchman, Ott and Antonsen 1992, Physical Review A 46, 6193.
class Glass {
 public:
  /// Needs   `scene` and `world` to outlive it.
  Glass(const Scene& scene, const World& world);
  bool any() const { return bodies_.any(); }

  /// The bodies that a ray is in which sets off from where it is; `departed` as OrbitStart has it. Exact.
  Media media_at(const Ray& ray, const DepartedSurface& departed) const {
    return bodies_.at(ray, departed);
  }
  /// Where an orbit meets a wall of glass.
  struct GlassHit {
    std::uint32_t surface;
    Sign side;               ///< it comes from (inner_side)
    Vec2 direction, normal;  ///< of length 1, the normal towards that side
  };
  /// Chance, uniform in [0, 1), decides: where it is refracted to, of length 1; nullopt: it is reflected.
  /// `media` are what it is in, and what it is in after.
  std::optional<Vec2> refracted(const GlassHit& meeting, Media& media, double chance) const;
  /// Of refraction, on the positive side of a wall and on the other, where bodies are not in one another.
  std::array<double, 2> indices(std::uint32_t surface) const;

 private:
  bool is_inside(std::uint32_t surface, Sign side) const;

  const Surfaces& walls_;
  std::vector<const Scatterer*> scatterers_;  // by surface
  Bodies bodies_;
};

/// What chance decides of an orbit by, under its number and a seed: OrbitStart::chance.
std::uint64_t chance_of_orbit(std::uint64_t seed, std::uint64_t number);

}  // namespace flatray
