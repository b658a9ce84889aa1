#pragma once
#include <cstdint>

#include "geom/hit_interval.h"
#include "geom/ray.h"
#include "trace/rays.h"

namespace flatray {

/// The first wall a ray meets at t >= 0.
///
/// Units   t counts lengths of the ray's direction.
/// Gives   kind: touch where the ray crosses a segment or is tangent to a curve, along where it
///         runs on a segment, through where it crosses a curve. Equal t: the lowest surface
///         number.
struct NearestHit {
  std::uint32_t surface = kNoSurface;
  HitClass kind = HitClass::miss;
  Root root = Root::none;  ///< of a curve; `both` where it is tangent
  bool at_end =
      false;  ///< exactly at an end of the wall, or in a cusp or crossing of a Bezier curve
  double t = kInfinity;  ///< the largest double where it lies beyond them

  explicit operator bool() const { return surface != kNoSurface; }
  bool operator==(const NearestHit&) const = default;
};

}  // namespace flatray
