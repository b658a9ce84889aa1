#pragma once
#include <span>
#include <vector>

#include "geom/ray.h"
#include "scene/scene.h"

namespace flatray {

/// How far a flattened round cap or join lies inside the true circle, in pixels, for strokes up to
/// 10^5 pixels wide; wider ones keep the chords of those. Part of the picture's stated
/// discretisation error; the straight sides of a stroke are exact.
inline constexpr double kCapSagitta_px = 1.0 / 256;

/// Points joined by straight lines; those of a closed chain come back to the first. What has no
/// length is a dot.
struct Chain {
  std::vector<Vec2> points;
  bool closed = false;
  /// Of every leg the unit directions at its beginning and at its end, which of chords are those of
  /// their curve; none where all are straight.
  std::vector<Vec2> ahead = {};
};

/// A chain from one point to the next, and its directions there.
struct ChainLeg {
  Vec2 a, b, from, to;
  double length;

  ChainLeg back() const { return {b, a, -to, -from, length}; }
};
std::vector<ChainLeg> legs_of(const Chain& chain);

/// A line's look in film pixels.
struct LineStyle {
  double half_width = 0.5;
  LineJoin joins = LineJoin::round;
  LineCap caps = LineCap::round;
  double miter_limit = 4;
};

/// Adds the outline of a line along a chain: what a pen as long as the line is wide, square to the
/// chain's direction, passes over, and joins where the direction jumps. The rings of several chains
/// may overlap: by nonzero winding all of them are one region.
///
/// Units   film pixels. Needs half_width > 0.
/// Gives   rings that wind 1, 2, ... times round what the line covers. Joins whose miter is more
///         than miter_limit times the line's width are bevels.
///         What half the width adds to a leg that bends is within a quarter of kCapSagitta_px.
///         false where these would be more than `most` edges: what is added then is no outline.
/// Cost    two edges a leg, and those of its joins; where a chain turns by so little that a bevel
///         stays within the sagitta, a round join is one edge.
bool add_line(const Chain& chain, const LineStyle& style, std::vector<Segment>& edges,
              std::uint64_t most = std::uint64_t{1} << 62);

/// How far from its chain a line may reach: no rounding leads beyond.
double line_reach(const LineStyle& style);

}  // namespace flatray
