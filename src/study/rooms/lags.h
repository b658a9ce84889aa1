#pragma once
#include <span>

#include "geom/vec.h"
#include "study/experiment.h"

namespace flatray {

/// When an orbit is looked at: `samples` times `step` apart, compared over fewer than `lags` steps.
struct LagTimes {
  double step;
  std::size_t samples, lags;
  double lag(std::size_t i) const { return step * static_cast<double>(i); }

  /// Of an orbit of so many flights, up to two thirds of its mean length, than which it is shorter
  /// once in some ten thousand times; over lags of up to a quarter of that.
  static LagTimes of(double mean_flight, std::uint64_t bounces);
};

/// What an orbit at speed 1 does over a time, by lag: means over all times at which it can begin.
struct Lags {
  Numbers x, y;      ///< squares of displacements
  Numbers velocity;  ///< v(0) v(t)
  Numbers kubo;      ///< v(0) (r(t) - r(0)), the integral of that

  /// Needs   more places than lags, and as many directions.
  static Lags of(std::span<const Vec2> places, std::span<const Vec2> ways, std::size_t lags);
};

}  // namespace flatray
