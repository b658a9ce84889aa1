#pragma once
#include <array>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "anim/frame_state.h"
#include "geom/ellipse.h"

namespace flatray {

/// Linear light with straight alpha.
struct LinearColour {
  float r = 0, g = 0, b = 0, a = 1;
  bool operator==(const LinearColour&) const = default;
};

inline std::array<float, 4> premultiplied(const LinearColour& c) {
  return {c.r * c.a, c.g * c.a, c.b * c.a, c.a};
}

/// Region bounded by directed edges in film coordinates (pixels, y down): the winding number at a
/// point counts the edges it passes. Edges that cancel have been left out. Need not be one ring;
/// every vertex is balanced.
struct FillPath {
  std::vector<Segment> edges;
  FillRule rule = FillRule::nonzero;
  bool simple = false;  ///< winding is 0 or 1 everywhere: one convex piece, or proven so
  bool operator==(const FillPath&) const = default;
};

/// Disc or annulus in film coordinates; with inner_radius < 0 it is a whole disc.
struct FillRing {
  Vec2 centre;
  double radius, inner_radius = -1;
  bool operator==(const FillRing&) const = default;
};

/// Region inside a closed path of arcs and straight lines in film coordinates that crosses itself
/// nowhere.
struct FillArcs {
  ArcPath path;
  bool operator==(const FillArcs&) const = default;
};

using Region = std::variant<FillPath, FillRing, FillArcs>;

/// Colours by a number t of each point p of the film: along a line (p - origin) . axis, round a
/// point |p - origin| * per_pixel. A pixel has the colour of its centre.
struct FilmGradient {
  struct Stop {
    double at;  ///< rising or equal
    LinearColour colour;
    bool operator==(const Stop&) const = default;
  };
  bool radial = false;
  Vec2 origin{0, 0}, axis{0, 0};
  double per_pixel = 0;
  std::vector<Stop> stops;  ///< at least one
  bool operator==(const FilmGradient&) const = default;
};

/// Light of the whole film, row by row from the top, three channels a pixel: added to what lies
/// below it.
struct LightPicture {
  std::vector<float> rgb;
};

struct DrawItem {
  Region region;
  /// Of a gradient its first stop's, but a is 1 only where all of it is opaque, and 0 only where
  /// none is seen.
  LinearColour colour;
  std::optional<FilmGradient> gradient{};
  std::shared_ptr<const LightPicture> light{};  ///< instead of a colour; the region is the film
  /// Not 0: items of one number, which follow one another, are painted on a clear layer of their
  /// own, and that is laid over the picture, faded by `opacity`.
  std::uint32_t layer = 0;
  float opacity = 1;
};

/// Pieces of edges in a pixel that are crossed pair by pair in pictures.
inline constexpr std::size_t kCrowd = 32;

/// What every back end draws: items in order, over the background.
struct DrawList {
  int width = 0, height = 0;
  LinearColour background;
  Coverage coverage = Coverage::area;
  std::vector<DrawItem> items;
  int rows = 4;                ///< as of Film
  std::size_t crowd = kCrowd;  ///< more of them in one pixel are summed by strips: PixelArea
};

}  // namespace flatray
