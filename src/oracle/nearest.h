#pragma once
#include <cstdint>
#include <span>

#include "geom/hit_interval.h"
#include "geom/ray.h"

namespace flatray::oracle {

/// The first wall a ray meets at t >= 0, as the tracers must answer.
struct NearestWall {
  std::int64_t wall = -1;  ///< the lowest of those met at the same time; -1 for none
  HitClass kind = HitClass::miss;
  bool at_end = false;
  double t = 0;                  ///< the nearest double; infinite beyond the doubles
  bool by_whole_numbers = true;  ///< else by rationals

  explicit operator bool() const { return wall >= 0; }
};

/// Source  the wall as a parametric segment: numerators of t and of the place on the wall against
///         one denominator, in whole numbers of 128 bits where the doubles allow it, else in
///         rationals; times compared by cross products of 256 bits. The quotient of t is the
///         engine's, too (geom/hit_time.h: any exact one is equal to it); verdicts, arithmetic and
///         rounding are not.
/// Cost    some 20 ns a wall; rationals some 10 us.
NearestWall nearest_wall(const Ray& ray, std::span<const Segment> walls);

}  // namespace flatray::oracle
