#pragma once
#include <optional>

#include "scene/scene.h"

namespace flatray {

/// All points within `radius` of a segment; of a point, where its ends are one.
struct Rounded {
  Vec2 from, to;
  double radius;
};

/// What encloses such a region: a capsule, or an ellipse that is a circle; nullopt of others. The
/// radius is that of a world, `curve_of`.
std::optional<Rounded> rounded_by(const ArcPath& path);

/// Of half-diameters across each other and of one length.
double circle_radius(const Vec2& u);

}  // namespace flatray
