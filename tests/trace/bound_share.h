#pragma once
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>

namespace flatray {

/// The largest share of a bound that is used, and the least that tells something of it.
struct BoundShare {
  const char* of;
  double least, worst = 0;
  void see(double error, double bound) { worst = std::max(worst, std::fabs(error) / bound); }
  void expect_told() const {
    fmt::print("worst error over bound: {:.3f} of {}\n", worst, of);
    EXPECT_LE(worst, 1) << of;
    EXPECT_GT(worst, least) << of << ": the draws are too easy";
  }
};

}  // namespace flatray
