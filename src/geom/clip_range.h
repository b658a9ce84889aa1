#pragma once
#include <optional>

#include "geom/hit_interval.h"
#include "geom/hit_time.h"

namespace flatray {

/// What the whole line of a ray has in common with a closed convex shape, before it is clipped to a
/// range. An end that is absent is unbounded; a touch has its point in both.
template <class Time>
struct LineHitOf {
  std::optional<Time> enter, exit;
  int edge_enter = kNoEdge, edge_exit = kNoEdge;
  HitClass kind = HitClass::miss;
};

using LineHit = LineHitOf<HitTime>;

/// Where a point lies that is to the inner side of a boundary, on it, or beyond.
constexpr StartPlace start_place(Sign inside) {
  return inside == Sign::negative ? StartPlace::outside
         : inside == Sign::zero   ? StartPlace::boundary
                                  : StartPlace::inside;
}

/// The answer for a ray without direction, whose origin lies at `place`: the whole range or a miss.
inline HitInterval point_test(StartPlace place, Range within) {
  if (place == StartPlace::outside || within.low > within.high) return {.start = place};
  const HitClass kind = place == StartPlace::inside ? HitClass::through : HitClass::touch;
  return {.t_enter = within.low, .t_exit = within.high, .kind = kind, .start = place};
}

namespace clipping {

// The two ends of a line hit against a number; an absent end is infinite.
template <class Time>
std::strong_ordering compare_enter(const LineHitOf<Time>& line, double t) {
  return line.enter ? line.enter->compare(t) : std::strong_ordering::less;
}
template <class Time>
std::strong_ordering compare_exit(const LineHitOf<Time>& line, double t) {
  return line.exit ? line.exit->compare(t) : std::strong_ordering::greater;
}

inline StartPlace place_of_start(HitClass kind, std::strong_ordering enter,
                                 std::strong_ordering exit) {
  if (kind == HitClass::miss || enter > 0 || exit < 0) return StartPlace::outside;
  return kind == HitClass::through && enter < 0 && exit > 0 ? StartPlace::inside
                                                            : StartPlace::boundary;
}

template <class Time>
void set_end(const Time& time, double& t, bool& overflows) {
  const RoundedTime rounded = time.nearest();
  t = rounded.t;
  overflows = rounded.overflows;
}

// The class of a part of the line that is not empty, from its ends against those of the range.
template <class Time>
HitClass class_within(const LineHitOf<Time>& line, Range within, std::strong_ordering enter_low,
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

}  // namespace clipping

/// The part of `line` within a range, its class there, and where t = 0 lies. Exact but for the
/// rounding of t. Needs   enter <= exit.
template <class Time>
HitInterval clip_to_range(const LineHitOf<Time>& line, Range within) {
  HitInterval hit;
  if (line.kind == HitClass::miss) return hit;
  const auto enter_low = clipping::compare_enter(line, within.low);
  const auto exit_high = clipping::compare_exit(line, within.high);
  hit.start = clipping::place_of_start(
      line.kind, within.low == 0 ? enter_low : clipping::compare_enter(line, 0),
      within.high == 0 ? exit_high : clipping::compare_exit(line, 0));
  if (within.low > within.high || clipping::compare_enter(line, within.high) > 0 ||
      clipping::compare_exit(line, within.low) < 0)
    return hit;
  hit.kind = clipping::class_within(line, within, enter_low, exit_high);
  hit.t_enter = within.low;
  hit.t_exit = within.high;
  // On a tie the end of the range stands, without an edge.
  if (enter_low > 0) {
    clipping::set_end(*line.enter, hit.t_enter, hit.enter_overflows);
    hit.edge_enter = line.edge_enter;
  }
  if (exit_high < 0) {
    clipping::set_end(*line.exit, hit.t_exit, hit.exit_overflows);
    hit.edge_exit = line.edge_exit;
  }
  return hit;
}

}  // namespace flatray
