#define FLATRAY_TIER portable
#define FLATRAY_KERNELS kPortable
#define FLATRAY_LANES 1
#include "collide/kernels/pairs_body.h"
