#pragma once
#include <array>

#include "scene/scene.h"

namespace flatray {

/// Light that comes to a wall.
struct Arrival {
  Vec2 direction;            ///< of length 1, towards the wall
  Vec2 normal;               ///< of length 1, towards the side it comes from
  bool from_inside = false;  ///< out of a closed shape
  double outer_index = 1;    ///< of refraction, of what is around the shape there
  double nm = 0;             ///< wavelength; 0: all of them together
  /// Where along a straight wall, from 0 to 1 as it was written; 0 on others, and for what asks not.
  double along = 0;
};

/// What becomes of it.
struct Departure {
  enum class Way : std::uint8_t {
    absorbed,
    mirrored,   ///< by the wall, exactly
    through,    ///< as if there were no wall
    scattered,  ///< in `direction`, to the side into which that leads
  };
  Way way = Way::absorbed;
  Vec2 direction{1, 0};                ///< of length 1
  std::array<float, 3> tint{1, 1, 1};  ///< of red, green and blue, what is left; the largest is 1
  bool stays = false;                  ///< scattered: to the side it comes from alone
};

/// Parts of the light that a wall sends on, from wherever it comes; the rest is absorbed.
struct LightShares {
  double diffuse = 0;    ///< by Lambert's law, to the side it comes from
  double isotropic = 0;  ///< alike into all directions, on both sides
  double mirror = 0, pass = 0;
  std::array<float, 3> tint{1, 1, 1};  ///< as Departure::tint
};

/// What a wall does with light.
class Scatterer {
 public:
  virtual ~Scatterer() = default;
  /// Needs   `u` in [0, 1), uniform: it chooses what happens and where to.
  virtual Departure scatter(const Arrival& arrival, double u) const = 0;
  /// The same whatever the direction of the light; null: it depends on it, as in glass.
  virtual const LightShares* shares() const { return nullptr; }
  /// What it is to orbits and rays that are drawn.
  virtual Material for_rays() const { return Material::absorb; }
  /// Of what fills its shape, for light of a wavelength; 0: light goes through the wall alone.
  virtual double index(double /*nm*/) const { return 0; }
  /// What part of red, green and blue is lost in what fills its shape on each unit of length, of what
  /// is left there: after a length d, exp(-absorption * d) is left.
  virtual std::array<double, 3> absorption() const { return {0, 0, 0}; }
  /// Whether what is behind it is seen through it: glass, and what half of the light passes.
  bool is_clear() const { return shares() != nullptr ? shares()->pass >= 0.5 : index(0) != 0; }
  /// Whether it asks for Arrival::along.
  virtual bool depends_on_place() const { return false; }
  /// Whether the index differs between wavelengths, so that light must have one.
  virtual bool disperses() const { return false; }
  /// Whether grey light may come away with a colour.
  virtual bool colours() const { return disperses(); }
};

}  // namespace flatray
