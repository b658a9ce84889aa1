#include "image/metric.h"

namespace flatray::rmse_metric {

extern const Metric entry = of_difference<&Difference::rmse>(
    "rmse", "root of the mean squared channel difference, levels or light");

}  // namespace flatray::rmse_metric
