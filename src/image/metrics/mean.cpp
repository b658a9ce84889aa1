#include "image/compare.h"
#include "image/metric.h"

namespace flatray::metric {
namespace {

template <class Picture>
double value(const Picture& actual, const Picture& expected) {
  return compare(actual, expected)->mean;
}

}  // namespace

extern const Metric mean = {"mean", "mean absolute channel difference, levels or light",
                            &value<Image>, &value<LinearImage>};

}  // namespace flatray::metric
