#include "image/compare.h"
#include "image/metric.h"

namespace flatray::metric {
namespace {

double value(const Image& actual, const Image& expected) { return compare(actual, expected)->rmse; }

}  // namespace

extern const Metric rmse = {"rmse", "root of the mean squared channel difference, levels", &value};

}  // namespace flatray::metric
