#pragma once
#include "render/draw_list.h"
#include "render/film_transform.h"

namespace flatray {

LinearColour linear(const Colour& colour);

/// A colour that changes, `curve` as of Paint: interpolated as premultiplied linear light.
LinearColour light_at(const Scene& scene, CurveId curve, double time);

FilmGradient film_gradient(const Gradient& gradient, const Pose& world_from_shape,
                           const FilmTransform& film_from_world);

/// The colour of an item that has this gradient.
LinearColour summary(const FilmGradient& gradient);

/// A gradient's colours.
///
/// Error   t in doubles, colours in floats, rounded step by step: the same bits on every machine.
class GradientPainter {
 public:
  explicit GradientPainter(const FilmGradient& gradient);

  /// Premultiplied, at a point of the film.
  std::array<float, 4> at(const Vec2& point) const;

 private:
  const FilmGradient& gradient_;
  std::vector<std::array<float, 4>> colours_;
};

}  // namespace flatray
