#include "image/metric.h"

namespace flatray::metric {

extern const Metric psnr =
    of_difference<&Difference::psnr>("psnr", "peak signal-to-noise ratio, dB; infinite when equal");

}  // namespace flatray::metric
