#include "render/backend.h"

namespace flatray {

#include "backends.inc"  // backends()

}  // namespace flatray
