#pragma once
#include <span>

#include "study/experiment.h"

namespace flatray {

/// Sums over independent samples (x, y) from which the ratio of their means is estimated.
struct RatioSums {
  double samples = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;

  void add(double sample_x, double sample_y);
  RatioSums& operator+=(const RatioSums& other);

  /// Sum of x over sum of y.
  double ratio() const { return x / y; }
  /// Of the ratio: that of the mean of x - ratio * y over the mean of y. Needs some 30 samples for
  /// it to mean anything.
  double standard_error() const;

  /// As six numbers, for blocks.
  void append_to(Numbers& numbers) const;
  static RatioSums from(std::span<const double> six);
};

/// Standard errors that a measure may lie from what must come out.
inline constexpr double kAllowedErrors = 4;
/// Half of an interval that covers the truth in 95 % of all runs, in standard errors.
inline constexpr double kHalfInterval = 1.96;

/// Whether a measure lies near enough to what is expected, where anything is.
bool agrees(const Measure& measure);

/// Result of an experiment whose answer is a list of measures: NAME.csv, NAME.json, and the table
/// as text after `headline`.
ExperimentResult measured(const ExperimentContext& context, const std::string& name,
                          const std::string& headline, std::vector<Measure> measures);

}  // namespace flatray
