#pragma once
#include <vector>

#include "image/compare.h"

namespace flatray {

/// One number from two pictures of one layout. A metric is a file in `metrics/` and a line in
/// CMake.
///
/// Needs   pictures `compare` accepts.
/// Gives   its value; equal pictures give 0, or infinity where more is better.
struct Metric {
  const char* name;
  const char* summary;
  double (*value)(const Image& actual, const Image& expected);
  double (*of_light)(const LinearImage& actual, const LinearImage& expected);
};

/// A metric that is one of the numbers of `compare`.
template <double Difference::*number>
constexpr Metric of_difference(const char* name, const char* summary) {
  const auto value = [](const auto& actual, const auto& expected) {
    return (*compare(actual, expected)).*number;
  };
  return {name, summary, value, value};
}

/// Registered metrics by name.
std::vector<const Metric*> metrics();

}  // namespace flatray
