#include "image/metric.h"

namespace flatray::metric {

extern const Metric mean =
    of_difference<&Difference::mean>("mean", "mean absolute channel difference, levels or light");

}  // namespace flatray::metric
