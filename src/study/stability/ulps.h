#pragma once
#include <cmath>

#include "geom/ray.h"

namespace flatray {

/// By how many units in the last place of the true one a t is off.
inline double ulps_between(double found, double truth) {
  if (found == truth) return 0;
  const double ulp = std::nextafter(std::fabs(truth), kInfinity) - std::fabs(truth);
  return std::fabs(found - truth) / ulp;
}

}  // namespace flatray
