#pragma once
#include "study/statistics/estimate.h"

namespace flatray {

/// Copies of a quasi-random sequence, each moved by a random shift of its own: what they differ by
/// is the error.
inline constexpr std::uint64_t kShifts = 32;

/// A point of the unit square, both coordinates in [0, 1).
struct UnitPoint {
  double x, y;
};

/// Point number / kShifts of the sequence under shift number % kShifts: so that any first numbers
/// are spread evenly, and number k is the same whatever comes before it.
///
/// Source  the additive recurrence R2 of M. Roberts (2018), frac(n / p), frac(n / p^2) with
///         p^3 = p + 1, in whole numbers of 64 bits; shifts modulo 1 (Cranley and Patterson 1976).
UnitPoint quasi_point(std::uint64_t seed, std::uint64_t number);

/// A number in [0, 1): draw `which` of start `number`.
double drawn_unit(std::uint64_t seed, std::uint64_t number, std::uint32_t which);

/// A ray from anywhere in a window in any direction, drawn by its number.
Ray random_ray(const Bounds& window, std::uint64_t seed, std::uint64_t number);

/// Sums over orbits from which a ratio of means and its error are estimated: under random starts
/// each orbit is a sample, under quasi-random ones all those of a shift together are, and under
/// conditional ones all those of a group.
class StartSums {
 public:
  explicit StartSums(Starts starts) : starts_(starts), sums_(samples_of(starts)) {}
  /// Puts orbit `number` in.
  void add(std::uint64_t number, double x, double y);
  RatioSums all() const;

  void append_to(SumList& list) { append(list, sums_); }

 private:
  static std::size_t samples_of(Starts starts) { return starts == Starts::random ? 1 : kShifts; }

  Starts starts_;
  std::vector<RatioSums> sums_;
};

}  // namespace flatray
