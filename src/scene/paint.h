#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "geom/vec.h"

namespace flatray {

/// sRGB with straight alpha, as written: "#rrggbb" or "#rrggbbaa".
struct Colour {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  bool operator==(const Colour&) const = default;
};

/// A number over time through its keys, constant before the first and after the last.
struct Curve {
  enum class Ease { linear, smooth, step } ease = Ease::linear;
  std::vector<double> times, values;  ///< seconds, ascending; one value each
  double largest = 0;                 ///< of the values, without their sign
};
using CurveId = std::uint32_t;  ///< index into Scene::curves

/// A number that may be a curve: its value, or 0 and the curve.
struct Moving {
  double value = 0;
  std::optional<CurveId> curve;
};

/// A point that may be a curve, or have curves as coordinates: added to where `value` leaves them.
struct MovingPoint {
  Vec2 value{0, 0};
  std::optional<CurveId> x, y;
};

/// Colours along a line or round a point, interpolated as premultiplied linear light; beyond the
/// first and the last they go on. In the coordinates of what is painted.
struct Gradient {
  struct Stop {
    double at;  ///< in [0, 1], not falling
    Colour colour;
  };
  bool radial = false;
  Vec2 from{0, 0};   ///< radial: the centre
  Vec2 along{1, 0};  ///< from there to where the last colour is; radial: to the right
  std::vector<Stop> stops;
};

inline constexpr std::uint32_t kNoEntry = ~std::uint32_t{0};

/// A colour, a gradient, or a colour that changes with time.
struct Paint : Colour {
  constexpr Paint() = default;
  constexpr Paint(const Colour& colour, std::uint32_t gradient_ = kNoEntry)
      : Colour(colour), gradient(gradient_) {}
  std::uint32_t gradient = kNoEntry;  ///< index into Scene::gradients: it counts, not the colour
  /// First of four curves: red, green and blue as linear light times alpha, and alpha. They count.
  CurveId curve = kNoEntry;
};

enum class LineJoin { round, miter, bevel };
enum class LineCap { round, butt, square };

/// Line drawn along an outline, centred on it.
struct Stroke {
  double width = 1;
  bool in_pixels = false;  ///< width and dashes in pixels of the film, else world units
  Paint colour;
  double scale = 1;  ///< of width and dashes that are not in pixels
  LineJoin joins = LineJoin::round;
  LineCap caps = LineCap::round;
  double miter_limit = 4;           ///< times the width; longer miters are bevels
  std::uint32_t dashes = kNoEntry;  ///< index into Scene::dashes
  double dash_offset = 0;
  std::optional<CurveId> width_curve{};  ///< instead of `width`: of entities and rays only
};

}  // namespace flatray
