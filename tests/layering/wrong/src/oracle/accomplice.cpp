// The oracle must share nothing with what draws.
#include "render/pass.h"
