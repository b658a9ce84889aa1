#pragma once
#include <functional>
#include <optional>

#include "geom/vec.h"

namespace flatray {

/// How far, in each coordinate, a rounded result may be moved to the side it must be on.
inline constexpr int kSearchUlps = 2;

/// The double `ulps` places from x, down if negative.
double step_ulps(double x, int ulps);

/// The first of `centre` and the doubles about it, nearest first, that is accepted; nullopt if none
/// within kSearchUlps in each coordinate is. Equal distances have a fixed order.
std::optional<Vec2> nearest_double(const Vec2& centre,
                                   const std::function<bool(const Vec2&)>& accepted);

}  // namespace flatray
