#define FLATRAY_TIER portable
#define FLATRAY_LANES 1
#include "trace/kernels/lane_body.h"
