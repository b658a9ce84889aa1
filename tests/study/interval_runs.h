#pragma once
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>

#include "study/statistics/estimate.h"

namespace flatray::testing {

/// What the intervals of many runs say of one truth.
class Runs {
 public:
  void add(const Measure& found, double truth) {
    if (!found.standard_error) {
      ++silent_;
      return;
    }
    const double off = found.value - truth, z = off == 0 ? 0 : off / *found.standard_error;
    ++runs_;
    sum_ += z;
    squares_ += z * z / (found.freedom > 2 ? found.freedom / (found.freedom - 2) : 3);
    const Range range = *interval(found);
    if (range.low <= truth && truth <= range.high) ++held_;
  }
  double runs() const { return runs_; }
  double held() const { return held_ / runs_; }
  double mean_z() const { return sum_ / runs_; }
  double rms_z() const { return std::sqrt(squares_ / runs_); }

  /// Within three and a half deviations of 95 % of a hundred runs that is 88 and more; errors twice as
  /// large, or half as large, are found by the squares.
  void expect_cover(const std::string& what, double most_silent = 0.1) const {
    fmt::print("{:<40} {:5} runs, {:5.1f} % held, mean z {:5.2f}\n", what, runs_, 100 * held(),
               mean_z());
    EXPECT_LE(silent_, most_silent * (runs_ + silent_)) << what;
    EXPECT_GE(held_, 0.95 * runs_ - 3.5 * std::sqrt(0.95 * 0.05 * runs_))
        << what << " of " << runs_;
    const double slack = 4.5 / std::sqrt(2 * runs_);
    EXPECT_GT(rms_z(), 1 - slack) << what;
    EXPECT_LT(rms_z(), 1 + slack) << what;
  }

 private:
  double runs_ = 0, held_ = 0, silent_ = 0, squares_ = 0, sum_ = 0;
};

}  // namespace flatray::testing
