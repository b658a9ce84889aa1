#include "image/compare.h"
#include "image/metric.h"

namespace flatray::metric {
namespace {

double value(const Image& actual, const Image& expected) {
  return compare(actual, expected)->worst;
}

}  // namespace

extern const Metric max = {"max", "largest channel difference, levels", &value};

}  // namespace flatray::metric
