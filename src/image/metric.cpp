#include "image/metric.h"

namespace flatray {

namespace metric {
#define FLATRAY_ENTRY(name) extern const Metric name;
#include "metrics.inc"
#undef FLATRAY_ENTRY
}  // namespace metric

std::vector<const Metric*> metrics() {
  return {
#define FLATRAY_ENTRY(name) &metric::name,
#include "metrics.inc"
#undef FLATRAY_ENTRY
  };
}

}  // namespace flatray
