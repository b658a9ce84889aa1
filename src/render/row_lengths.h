#pragma once
#include <vector>

#include "geom/interval_set.h"
#include "trace/rays.h"

namespace flatray {

/// How much of the way ahead of each ray of a row lies in some parts, from where these lie on the
/// first ray alone: all rays are of one line.
///
/// Needs   rays to the right at one height, of one direction, from left to right; parts within the
///         first of them at t >= 0, each end within an ulp.
/// Error   error(): of m parts that end at T or before, (8 m + 8) 2^-52 T. Of the sum over each ray's
///         own parts an end is off by an ulp of T at most, likewise here, and where a ray stands is
///         by two roundings: together 2 m + 2 m + 1 ulps, for what the ends of a part are off by is
///         the most that their union is. Each of two sums of m lengths rounds 2 m times by half an
///         ulp of T: 2 m more. The rest covers the second order.
/// Cost    O(parts) once, then as rays are asked from left to right constant on average.
class RowLengths {
 public:
  explicit RowLengths(std::vector<Range> parts);

  /// Of a ray that sets off at `t` of the first. Needs   no t below the one before.
  double ahead(double t);
  /// What that, or the sum over the ray's own parts in doubles, is off from the other.
  double error() const { return error_; }

 private:
  double error_;
  IntervalSet set_;
  std::vector<double> after_;  // the length of all parts after each
  std::size_t next_ = 0;       // the first part that is not behind
};

}  // namespace flatray
