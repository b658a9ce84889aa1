#include "image/metric.h"

namespace flatray::psnr_metric {

extern const Metric entry =
    of_difference<&Difference::psnr>("psnr", "peak signal-to-noise ratio, dB; infinite when equal");

}  // namespace flatray::psnr_metric
