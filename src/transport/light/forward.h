#pragma once
#include <span>

#include "anim/lamps.h"
#include "anim/world.h"
#include "scene/scatterer.h"
#include "trace/tracer.h"
#include "transport/light/traced_light.h"

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
  int channels = 3;                ///< of the film; 1 where all light is grey
};

/// Follows light from its lamps, and adds the length of every path in every pixel.
///
/// Needs   lamps. Scatterers by surface, nullptr where its owner's material says
///         all. `worlds` are one, or those of anim/world.h's alternatives: each leg is in one of them, by
///         chance. `light` of the same frame and rules, or empty: more rounds are added to it.
/// Gives   the same sums for any number of threads, tier and exact tracer, and for any order of the
///         rounds. A point lamp of power 1 with nothing in the way: 1 / (2 pi r), averaged over each
///         pixel. It ends where another round could be more lines than a film counts.
/// Error   what a ray meets is decided exactly, and none gets through a closed wall (lit_walls.h). One
///         that comes to a corner ends there. Where bodies absorb, a flight is pieces of even weight,
///         each the mean there, over a 16th of what light falls to 1/e in or an 8th of a pixel.
/// Source  Jarosz et al. 2012, "Theory, analysis and applications of 2D global illumination".
TracedLight trace_light(std::span<const World> worlds, std::span<const Scatterer* const> scatterers,
                        std::span<const LampState> lamps, const FilmPlace& place,
                        const LightRules& rules, TracedLight light, const NextRound& next);

}  // namespace flatray
