#pragma once
#include <algorithm>
#include <cmath>

#include "base/portable_math.h"

namespace flatray {

/// Area between a chord and its arc, at most half a turn: r^2 (asin s - s sqrt(1 - s^2)),
/// s = chord / 2r; where the two terms cancel, their series, which leaves out less than 2^-43 of
/// it.
inline double circle_segment(double r, double chord) {
  const double s = std::min(chord / (2 * r), 1.0), z = s * s;
  if (s < 0x1p-4) {
    const double tail =
        2.0 / 3 + z * (1.0 / 5 + z * (3.0 / 28 + z * (5.0 / 72 + z * (35.0 / 704))));
    return chord * s * s * 0.5 * r * tail;
  }
  return r * r * (portable::asin(s) - s * std::sqrt(1 - z));
}

}  // namespace flatray
