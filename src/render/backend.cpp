#include "render/backend.h"

namespace flatray {

#define FLATRAY_ENTRY(name) extern const Backend name##_backend;
#include "backends.inc"
#undef FLATRAY_ENTRY

std::vector<const Backend*> backends() {
  return {
#define FLATRAY_ENTRY(name) &name##_backend,
#include "backends.inc"
#undef FLATRAY_ENTRY
  };
}

}  // namespace flatray
