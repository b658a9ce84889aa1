#include "geom/clip_range.h"

namespace flatray {
namespace {

// The two ends of a line hit against a number; an absent end is infinite.
std::strong_ordering compare_enter(const LineHit& line, double t) {
  return line.enter ? line.enter->compare(t) : std::strong_ordering::less;
}
std::strong_ordering compare_exit(const LineHit& line, double t) {
  return line.exit ? line.exit->compare(t) : std::strong_ordering::greater;
}

StartPlace place_of_start(HitClass kind, std::strong_ordering enter, std::strong_ordering exit) {
  if (kind == HitClass::miss || enter > 0 || exit < 0) return StartPlace::outside;
  return kind == HitClass::through && enter < 0 && exit > 0 ? StartPlace::inside
                                                            : StartPlace::boundary;
}

void set_enter(const LineHit& line, HitInterval& hit) {
  const RoundedTime time = line.enter->nearest();
  hit.t_enter = time.t;
  hit.enter_overflows = time.overflows;
  hit.edge_enter = line.edge_enter;
}

void set_exit(const LineHit& line, HitInterval& hit) {
  const RoundedTime time = line.exit->nearest();
  hit.t_exit = time.t;
  hit.exit_overflows = time.overflows;
  hit.edge_exit = line.edge_exit;
}

// The class of a part of the line that is not empty, from its ends against those of the range.
HitClass class_within(const LineHit& line, Range within, std::strong_ordering enter_low,
                      std::strong_ordering exit_high) {
  const bool from_range = enter_low <= 0, to_range = exit_high >= 0;
  const bool one_point = from_range && to_range ? within.low == within.high
                         : from_range           ? compare_exit(line, within.low) == 0
                         : to_range             ? compare_enter(line, within.high) == 0
                                                : false;
  if (!one_point) return line.kind;
  const bool inner =
      line.kind == HitClass::through && from_range && to_range && enter_low < 0 && exit_high > 0;
  return inner ? HitClass::through : HitClass::touch;
}

}  // namespace

HitInterval clip_to_range(const LineHit& line, Range within) {
  HitInterval hit;
  if (line.kind == HitClass::miss) return hit;
  const auto enter_low = compare_enter(line, within.low);
  const auto exit_high = compare_exit(line, within.high);
  hit.start = place_of_start(line.kind, within.low == 0 ? enter_low : compare_enter(line, 0),
                             within.high == 0 ? exit_high : compare_exit(line, 0));
  if (within.low > within.high || compare_enter(line, within.high) > 0 ||
      compare_exit(line, within.low) < 0)
    return hit;
  hit.kind = class_within(line, within, enter_low, exit_high);
  hit.t_enter = within.low;
  hit.t_exit = within.high;
  // On a tie the end of the range stands, without an edge.
  if (enter_low > 0) set_enter(line, hit);
  if (exit_high < 0) set_exit(line, hit);
  return hit;
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
