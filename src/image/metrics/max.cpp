#include "image/metric.h"

namespace flatray::metric {

extern const Metric max =
    of_difference<&Difference::worst>("max", "largest channel difference, levels or light");

}  // namespace flatray::metric
