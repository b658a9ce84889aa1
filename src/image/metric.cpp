#include "image/metric.h"

namespace flatray {

#include "metrics.inc"  // metrics()

}  // namespace flatray
