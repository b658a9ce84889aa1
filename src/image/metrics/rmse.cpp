#include "image/metric.h"

namespace flatray::metric {

extern const Metric rmse = of_difference<&Difference::rmse>(
    "rmse", "root of the mean squared channel difference, levels or light");

}  // namespace flatray::metric
