#include "image/compare.h"
#include "image/metric.h"

namespace flatray::metric {
namespace {

double value(const Image& actual, const Image& expected) { return compare(actual, expected)->mean; }

}  // namespace

extern const Metric mean = {"mean", "mean absolute channel difference, levels", &value};

}  // namespace flatray::metric
