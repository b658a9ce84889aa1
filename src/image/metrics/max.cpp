#include "image/metric.h"

namespace flatray::max_metric {

extern const Metric entry =
    of_difference<&Difference::worst>("max", "largest channel difference, levels or light");

}  // namespace flatray::max_metric
