#include "image/compare.h"
#include "image/metric.h"

namespace flatray::metric {
namespace {

template <class Picture>
double value(const Picture& actual, const Picture& expected) {
  return compare(actual, expected)->rmse;
}

}  // namespace

extern const Metric rmse = {"rmse", "root of the mean squared channel difference, levels or light",
                            &value<Image>, &value<LinearImage>};

}  // namespace flatray::metric
