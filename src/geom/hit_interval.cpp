#include "geom/hit_interval.h"

#include "base/check.h"

namespace flatray {

const char* name(HitClass kind) {
  switch (kind) {
    case HitClass::miss:
      return "miss";
    case HitClass::touch:
      return "touch";
    case HitClass::along:
      return "along";
    case HitClass::through:
      return "through";
  }
  unreachable();
}

const char* name(StartPlace start) {
  switch (start) {
    case StartPlace::outside:
      return "outside";
    case StartPlace::boundary:
      return "boundary";
    case StartPlace::inside:
      return "inside";
  }
  unreachable();
}

}  // namespace flatray
