#include "image/compare.h"
#include "image/metric.h"

namespace flatray::metric {
namespace {

template <class Picture>
double value(const Picture& actual, const Picture& expected) {
  return compare(actual, expected)->worst;
}

}  // namespace

extern const Metric max = {"max", "largest channel difference, levels or light", &value<Image>,
                           &value<LinearImage>};

}  // namespace flatray::metric
