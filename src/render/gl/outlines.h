#pragma once
#include <span>
#include <vector>

#include "geom/bounds.h"
#include "geom/ray.h"

namespace flatray::gl {

/// A closed line through corners, the last joined to the first. Coordinates are pixels.
using Ring = std::vector<Vec2>;

/// A circle as a ring: chords within 1/256 of a pixel of it, longer ones where they lie outside
/// `box`.
Ring circle_ring(const Vec2& centre, double radius, const Bounds& box);

/// The part of a convex ring inside `box`, convex again.
Ring clipped(Ring ring, const Bounds& box);

/// The ring with what lies outside `box` moved to its border: winding numbers inside stay.
Ring clamped(const Ring& ring, const Bounds& box);

}  // namespace flatray::gl
