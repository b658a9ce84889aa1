#pragma once
#include <span>

#include "anim/lamps.h"
#include "anim/world.h"
#include "image/light_film.h"
#include "scene/scatterer.h"
#include "trace/tracer.h"

namespace flatray {

/// Where a film lies in the world: pixels, y down.
struct FilmPlace {
  double left, top;        ///< world
  double pixels_per_unit;  ///< of world length
  int width, height;
};

/// How light is to be traced.
struct LightRules {
  LightSettings light;
  std::uint64_t seed = 0;
  unsigned frame = 0;  ///< that names the random numbers
  unsigned threads = 1;
  const Tracer* tracer = nullptr;  ///< null: the one of choice
  bool (*stop)() = nullptr;        ///< asked between waves: true ends it
};

/// What became of the light, in units of 2^-20 of a channel of a ray: what was emitted is the sum of
/// the others, exactly.
struct LightCounts {
  std::uint64_t rays = 0, legs = 0;  ///< legs: straight parts of paths
  std::int64_t emitted = 0, absorbed = 0, escaped = 0;
  std::int64_t at_corners = 0;  ///< met the end of a wall, or a point where walls meet
  std::int64_t cut_off = 0;     ///< after the last bounce allowed
  std::int64_t gambled = 0;     ///< lost, less won, by faint rays of which some go on brighter

  LightCounts& operator+=(const LightCounts& more);
};

/// The light of a frame.
struct TracedLight {
  LightFilm film;
  double unit;  ///< fluence (power per world length) of one unit of its sums
  LightCounts counts;
  bool whole = true;  ///< not stopped
};

/// Rays in blocks of so many, fixed by their numbers: more rays are more blocks.
inline constexpr std::uint64_t kLightBlock = std::uint64_t{1} << 18;
/// What is traced of `rays` asked for, but for rounding to the shares of the lamps: all of a block at
/// most, else whole blocks.
std::uint64_t rays_traced(std::uint64_t rays);

/// Follows light from its lamps, and adds the length of every path in every pixel.
///
/// Needs   lamps. Scatterers by surface, nullptr where its owner's material says
///         all. `worlds` are one, or those of anim/world.h's alternatives: each leg is in one of them, by
///         chance.
/// Gives   the same sums for any number of threads, tier and exact tracer. A point lamp of power 1
///         with nothing in the way: 1 / (2 pi r), averaged over each pixel.
/// Error   rays are followed as orbits are (transport/orbit.h): none gets through a closed wall. One
///         that comes to a corner ends there.
/// Source  Jarosz et al. 2012, "Theory, analysis and applications of 2D global illumination".
TracedLight trace_light(std::span<const World> worlds, std::span<const Scatterer* const> scatterers,
                        std::span<const LampState> lamps, const FilmPlace& place,
                        const LightRules& rules);

}  // namespace flatray
