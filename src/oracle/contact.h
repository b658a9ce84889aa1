#pragma once
#include <optional>
#include <span>

#include "geom/exact.h"
#include "geom/hit_interval.h"
#include "geom/ray.h"

namespace flatray::oracle {

/// A convex core that moves, with all points within `radius` of it.
struct MovingCore {
  std::span<const Vec2> ring;
  Vec2 velocity;
  double radius = 0;
};

/// When two moving bodies meet, as contact() must answer.
struct ContactTruth {
  HitClass kind = HitClass::miss;
  StartPlace start = StartPlace::outside;
  std::optional<Rational> first, last;  ///< absent where unbounded, or a miss
};

/// Needs   rings as contact() does, within.low <= within.high; with a radius, `within` kRay or kLine.
/// Gives   of round bodies the times of what only touches.
/// Source  separating axes: on each the shadows of the two must overlap, which holds for a closed
///         interval of t; neither the difference of the shapes nor sides of a line are formed. Of round
///         bodies the distance is convex in t, so where it never falls to the sum of the radii it does not
///         do so when any two vertices are nearest, nor when the cores cross; where it only comes to be
///         that sum, the first and the last time two vertices are nearest are the ends.
/// Cost    some 50 us, of round bodies 100.
ContactTruth contact_truth(const MovingCore& a, const MovingCore& b, Range within);

/// How two bodies lie at time t: negative where they overlap, zero where they touch. Needs cores that are
/// apart or touch.
///
/// Source  squared distances of points from segments, in rationals; no difference of shapes and no
///         quadratic in t.
Sign apart_at(const MovingCore& a, const MovingCore& b, const Rational& t);

}  // namespace flatray::oracle
