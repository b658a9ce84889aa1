#include "image/metric.h"

namespace flatray::mean_metric {

extern const Metric entry =
    of_difference<&Difference::mean>("mean", "mean absolute channel difference, levels or light");

}  // namespace flatray::mean_metric
