#include "image/compare.h"
#include "image/metric.h"

namespace flatray::metric {
namespace {

template <class Picture>
double value(const Picture& actual, const Picture& expected) {
  return compare(actual, expected)->psnr;
}

}  // namespace

extern const Metric psnr = {"psnr", "peak signal-to-noise ratio, dB; infinite when equal",
                            &value<Image>, &value<LinearImage>};

}  // namespace flatray::metric
