#pragma once
#include "oracle/contact.h"

namespace flatray::oracle {

/// A convex core that moves, with all points within `radius` of it.
struct RoundCore {
  std::span<const Vec2> ring;
  Vec2 velocity;
  double radius;
};

/// How two such bodies lie at time t: negative where they overlap, zero where they touch. Needs
/// cores that are apart or touch.
///
/// Source  squared distances of points from segments, in rationals; no difference of shapes and no
///         quadratic in t.
Sign apart_at(const RoundCore& a, const RoundCore& b, const Rational& t);

/// When two such bodies meet; the times of what only touches.
///
/// Needs   a radius above 0; `within` kRay or kLine.
/// Source  the distance is convex in t, so where it never falls to the sum of the radii it does not do
///         so when any two vertices are nearest, nor when the cores cross; where it only comes to be
///         that sum, the first and the last time two vertices are nearest are the ends.
/// Cost    some 100 us.
ContactTruth round_truth(const RoundCore& a, const RoundCore& b, Range within);

}  // namespace flatray::oracle
