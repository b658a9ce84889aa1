#pragma once
#include <cstdint>
#include <optional>
#include <span>

#include "geom/vec.h"

namespace flatray {

/// How far, in each coordinate, a rounded result may be moved to the side it must be on.
inline constexpr int kSearchUlps = 2;

/// The double `ulps` places from x, down if negative; infinity beyond the last. Never -0.
double step_ulps(double x, int ulps);

/// Doubles to one side of a point, in ulps of its coordinates.
struct UlpSteps {
  std::int8_t x, y;
};
/// Those within kSearchUlps of `centre` in each coordinate but itself, nearest first. An ulp is that
/// away from 0; equal distances have a fixed order.
std::span<const UlpSteps> steps_about(const Vec2& centre);

/// The first of `centre` and the doubles about it, nearest first, that is finite and accepted; nullopt
/// if none within kSearchUlps in each coordinate is.
template <class Accepted>
std::optional<Vec2> nearest_double(const Vec2& centre, const Accepted& accepted) {
  const auto is_taken = [&](const Vec2& point) { return point.allFinite() && accepted(point); };
  if (is_taken(centre)) return centre;
  for (const UlpSteps& step : steps_about(centre)) {
    const Vec2 candidate(step_ulps(centre.x(), step.x), step_ulps(centre.y(), step.y));
    if (is_taken(candidate)) return candidate;
  }
  return std::nullopt;
}

}  // namespace flatray
