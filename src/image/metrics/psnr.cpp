#include "image/compare.h"
#include "image/metric.h"

namespace flatray::metric {
namespace {

double value(const Image& actual, const Image& expected) { return compare(actual, expected)->psnr; }

}  // namespace

extern const Metric psnr = {"psnr", "peak signal-to-noise ratio, dB; infinite when equal", &value};

}  // namespace flatray::metric
