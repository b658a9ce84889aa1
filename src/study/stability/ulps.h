#pragma once
#include <algorithm>
#include <cmath>

#include "geom/ray.h"

namespace flatray {

/// By how many units in the last place of the true one a t is off.
inline double ulps_between(double found, double truth) {
  if (found == truth) return 0;
  const double ulp = std::nextafter(std::fabs(truth), kInfinity) - std::fabs(truth);
  return std::fabs(found - truth) / ulp;
}

/// The double that stands for a time beyond the doubles.
inline double as_double(double t) { return std::min(t, std::numeric_limits<double>::max()); }

/// Whether it is the double nearest to the true one, or beside it.
inline bool is_within_ulp(double found, double truth) {
  return found >= std::nextafter(truth, -kInfinity) && found <= std::nextafter(truth, kInfinity);
}

}  // namespace flatray
