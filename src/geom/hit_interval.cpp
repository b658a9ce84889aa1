#include "geom/hit_interval.h"

namespace flatray {

const char* name(HitClass kind) {
  constexpr const char* kNames[] = {"miss", "touch", "along", "through"};
  return kNames[static_cast<int>(kind)];
}

const char* name(StartPlace start) {
  constexpr const char* kNames[] = {"outside", "boundary", "inside"};
  return kNames[static_cast<int>(start)];
}

}  // namespace flatray
