#pragma once
#include "study/room.h"

namespace flatray {

/// What becomes of an orbit that starts at the centre of a pixel.
struct PixelOutcome {
  enum class Kind : std::uint8_t {
    solid,    ///< the pixel lies in an obstacle, or outside the chamber
    limit,    ///< all bounces were made
    escape,   ///< it left into the open
    absorbed  ///< by `surface`
  } kind = Kind::solid;
  std::uint32_t bounces = 0;
  std::uint32_t surface = kNoSurface;
  double length = 0;  ///< of the path to the last bounce
  Vec2 out{0, 0};     ///< direction at the end
};

/// One orbit for every pixel of the scene's film, rows top-down, as the context's map says, or
/// `usual`. A scene without rays has one from the middle of its window to the right. Orbits that
/// end in a corner count as absorbed by its lowest wall.
Result<std::vector<PixelOutcome>> trace_pixels(const ExperimentContext& context, const Room& room,
                                               std::uint64_t bounces, PixelMap usual);

}  // namespace flatray
