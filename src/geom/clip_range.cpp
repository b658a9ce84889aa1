#include "geom/clip_range.h"

namespace flatray {

HitInterval clip_to_range(const LineHit& line, Range within) {
  return clip_to_range<HitTime>(line, within);
}

HitInterval point_test(StartPlace place, Range within) {
  HitInterval hit;
  hit.start = place;
  if (place == StartPlace::outside || within.low > within.high) return hit;
  hit.kind = place == StartPlace::inside ? HitClass::through : HitClass::touch;
  hit.t_enter = within.low;
  hit.t_exit = within.high;
  return hit;
}

}  // namespace flatray
