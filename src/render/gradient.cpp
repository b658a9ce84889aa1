#include "render/gradient.h"

#include <algorithm>
#include <cmath>

#include "image/srgb.h"
#include "scene/curve.h"

namespace flatray {

LinearColour linear(const Colour& colour) {
  return {linear_from_srgb(colour.r), linear_from_srgb(colour.g), linear_from_srgb(colour.b),
          static_cast<float>(colour.a) / 255.0F};
}

LinearColour light_at(const Scene& scene, CurveId curve, double time) {
  const double alpha = value_at(scene.curves[curve + 3], time);
  if (!(alpha > 0)) return {0, 0, 0, 0};
  const auto light = [&](CurveId i) {
    return static_cast<float>(std::min(value_at(scene.curves[curve + i], time) / alpha, 1.0));
  };
  return {light(0), light(1), light(2), static_cast<float>(alpha)};
}

// Shorter than kLeast_px it is taken as that long: every pixel centre but one at its origin then lies beyond
// its ends.
FilmGradient film_gradient(const Gradient& gradient, const Pose& world_from_shape,
                           const FilmTransform& film_from_world) {
  FilmGradient there;
  there.radial = gradient.radial;
  there.origin = film_from_world(world_from_shape(gradient.from));
  constexpr double kLeast_px = 0x1p-100;
  const Vec2 way = world_from_shape.turned(gradient.along), along = film_from_world.direction(way);
  const double square = along.squaredNorm();
  const bool has_length = square > kLeast_px * kLeast_px;
  there.axis = has_length ? Vec2(along / square) : unit({way.x(), -way.y()}) / kLeast_px;
  there.per_pixel = 1 / (has_length ? std::sqrt(square) : kLeast_px);
  for (const Gradient::Stop& stop : gradient.stops)
    there.stops.push_back({stop.at, linear(stop.colour)});
  return there;
}

LinearColour summary(const FilmGradient& gradient) {
  LinearColour colour = gradient.stops.front().colour;
  const auto all = [&](float alpha) {
    return std::all_of(gradient.stops.begin(), gradient.stops.end(),
                       [&](const FilmGradient::Stop& stop) { return stop.colour.a == alpha; });
  };
  colour.a = all(1) ? 1.0F : all(0) ? 0.0F : 0.5F;
  return colour;
}

GradientPainter::GradientPainter(const FilmGradient& gradient) : gradient_(gradient) {
  for (const FilmGradient::Stop& stop : gradient.stops)
    colours_.push_back(premultiplied(stop.colour));
}

std::array<float, 4> GradientPainter::at(const Vec2& point) const {
  const double dx = point.x() - gradient_.origin.x(), dy = point.y() - gradient_.origin.y();
  const double t = gradient_.radial ? std::sqrt(dx * dx + dy * dy) * gradient_.per_pixel
                                    : dx * gradient_.axis.x() + dy * gradient_.axis.y();
  const auto& stops = gradient_.stops;
  std::size_t next = 0;
  while (next < stops.size() && stops[next].at <= t) ++next;
  if (next == 0) return colours_.front();
  if (next == stops.size()) return colours_.back();
  const double from = stops[next - 1].at;
  const auto share = static_cast<float>((t - from) / (stops[next].at - from));
  std::array<float, 4> colour = colours_[next - 1];
  for (std::size_t i = 0; i < 4; ++i) colour[i] += (colours_[next][i] - colour[i]) * share;
  return colour;
}

}  // namespace flatray
