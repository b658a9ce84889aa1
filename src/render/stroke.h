#pragma once
#include <span>
#include <vector>

#include "geom/ray.h"

namespace flatray {

/// How far a flattened round cap or join lies inside the true circle, in pixels, for strokes up to
/// 10^5 pixels wide; wider ones keep the chords of those. Part of the picture's stated
/// discretisation error; the straight sides of a stroke are exact.
inline constexpr double kCapSagitta_px = 1.0 / 256;

/// Adds the outline of a line of the given half width around a segment, with round ends: one convex
/// ring of directed edges. Rings of neighbouring segments overlap in their round ends, so their
/// union has round joins.
///
/// Units   film pixels. Needs half_width > 0. A segment without length is a disc.
void add_capsule(const Segment& segment, double half_width, std::vector<Segment>& edges);

}  // namespace flatray
