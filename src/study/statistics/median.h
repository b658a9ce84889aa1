#pragma once
#include <vector>

namespace flatray {

/// A median and an interval that holds the median of what the values are drawn from.
struct MedianInterval {
  double median = 0, low = 0, high = 0;
  double confidence = 0;  ///< the share of draws whose interval holds it, at the least
};

/// From order statistics, whatever the distribution: the two values between which the number that
/// lie below the true median, binomial with 1/2, stays with at least `confidence`.
///
/// Needs   values drawn independently, at least one. Where all of them are too few for `confidence`
///         the interval is their range, whose confidence is less.
MedianInterval median_interval(std::vector<double> values, double confidence);

}  // namespace flatray
