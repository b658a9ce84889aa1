#pragma once
#include <functional>

#include "study/plots/plot.h"
#include "study/rooms/room.h"
#include "study/rooms/starts.h"

namespace flatray {

/// What becomes of an orbit that starts at a place of the picture.
struct PixelOutcome {
  enum class Kind : std::uint8_t {
    solid,     ///< the place lies in an obstacle, or outside the chamber
    limit,     ///< all bounces were made
    escape,    ///< it left into the open
    absorbed,  ///< by `surface`
    corner     ///< it ended in a corner, or along a wall: `surface` is the lowest of its walls
  } kind = Kind::solid;
  std::uint32_t bounces = 0;
  std::uint32_t surface = kNoSurface;
  double length = 0;  ///< of the path to the last bounce
  Vec2 out{0, 0};     ///< direction at the end
  Vec2 at{0, 0};      ///< where it was absorbed, or bounced last
  double way = 0;     ///< of the path up to there
};

/// Where orbits set off of places of the picture, (0, 0) its upper left corner and (1, 1) its lower
/// right one, as the context's map says, or `usual`. A scene without rays has one from the middle
/// of its window to the right.
class PlaceStarts {
 public:
  PlaceStarts(const ExperimentContext& context, const Room& room, PixelMap usual);
  /// None where the place lies in an obstacle, or outside the chamber.
  std::optional<OrbitStart> operator[](const UnitPoint& place) const;

 private:
  const Room& room_;
  const Bounds& window_ = room_.state().window;
  PixelMap map_;
  Ray ray_;
};

/// `count` orbits, each from where `start` has it: the first `exact` of them exactly decided, the
/// others in the precision of the context.
Result<std::vector<PixelOutcome>> trace_outcomes(
    const ExperimentContext& context, const Room& room, std::uint64_t bounces, std::uint64_t count,
    std::uint64_t exact, const std::function<std::optional<OrbitStart>(std::uint64_t)>& start);

/// `count` orbits of starts drawn on the walls by the measure that reflection keeps, none of which an
/// experiment draws for its own results: what it looks at first, to see what room it has. A monitor
/// is asked to stop and told nothing; nothing is certified.
Result<std::vector<PixelOutcome>> trace_pilot(const ExperimentContext& context, const Room& room,
                                              std::uint64_t bounces, std::uint64_t count);

/// The centre of a pixel; any place in it; any place of the picture. Drawn by their number.
UnitPoint pixel_centre(const Film& film, std::uint64_t pixel);
UnitPoint drawn_in_pixel(const Film& film, std::uint64_t pixel, std::uint64_t seed);
UnitPoint drawn_place(std::uint64_t seed, std::uint64_t number);
std::uint64_t pixel_count(const Film& film);

/// One orbit from the centre of every pixel of the scene's film, rows top-down.
Result<std::vector<PixelOutcome>> trace_pixels(const ExperimentContext& context, const Room& room,
                                               std::uint64_t bounces, PixelMap usual);

/// A map of such pixels, with axes that say where each orbit starts: world x and y, or the place on
/// the line across the ray and the angle to it.
Plot pixel_plot(const ExperimentContext& context, const Room& room, PixelMap usual,
                const std::function<LinearRgb(std::size_t)>& colour);
/// How many bounces, for a table; "" of what starts no orbit.
std::string bounces_text(const PixelOutcome& pixel);

}  // namespace flatray
