#define FLATRAY_TIER portable
#define FLATRAY_LANES 1
#include "transport/kernels/flights_body.h"
