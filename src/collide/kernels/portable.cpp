#define FLATRAY_TIER portable
#define FLATRAY_LANES 1
#include "collide/kernels/pairs_body.h"
