#include "trace/exact_nearest.h"

#include <algorithm>

namespace flatray {
ExactNearest::ExactNearest(const Surfaces& walls, const Ray& ray, const DepartedSurface& departed,
                           bool tangents, bool all)
    : walls_(walls),
      ray_(ray),
      departed_(departed),
      tangents_(tangents),
      point_test_(ray.direction == Vec2(0, 0)),
      all_(all) {}

void ExactNearest::offer(const NearestHit& hit, const HitTime& time) {
  if (time.sign() == Sign::negative) return;
  if (all_) {
    every_.push_back({hit, time});
    return;
  }
  if (best_time_) {
    const std::strong_ordering order = compare(time, *best_time_);
    if (order > 0 || (order == 0 && hit.surface > best_.surface)) return;
  }
  best_ = hit;
  best_time_ = time;
}

void ExactNearest::offer_point_test(std::uint32_t number, PlaceOn place) {
  if (place == PlaceOn::outside) return;
  const NearestHit hit{number, HitClass::touch, Root::none, place == PlaceOn::at_end, 0};
  if (all_)
    every_.push_back({hit, std::nullopt});
  else if (number <= best_.surface)
    best_ = hit;
}

void ExactNearest::offer(std::uint32_t surface) {
  const bool left = surface == departed_.surface;
  walls_.visit(surface, [&](const auto& wall) {
    if (left && is_departed_for_good(wall, departed_.root)) return;
    if (point_test_) {
      const PlaceOn place = place_on(wall, ray_.origin);
      if (left && departed_.root == Root::both && place == PlaceOn::inner) return;
      return offer_point_test(surface, place);
    }
    met_.clear();
    meet(wall, ray_, {left ? departed_.root : Root::none, tangents_, all_}, met_);
    for (const WallMeeting& met : met_)
      offer({surface, met.kind, met.root, met.at_end, 0}, met.time);
  });
}

void ExactNearest::offer_all() {
  for (std::uint32_t i = 0; i < walls_.size(); ++i) offer(i);
}

NearestHit ExactNearest::hit() const {
  NearestHit hit = best_;
  if (best_time_) hit.t = best_time_->nearest().t;
  return hit;
}

// Rounding keeps order, so that exact times are compared only where the doubles are equal.
std::vector<NearestHit> ExactNearest::hits() {
  for (Timed& one : every_)
    if (one.time) one.hit.t = one.time->nearest().t;
  const auto is_before = [](const Timed& a, const Timed& b) {
    if (a.hit.t != b.hit.t) return a.hit.t < b.hit.t;
    if (a.time && b.time)
      if (const std::strong_ordering order = compare(*a.time, *b.time); order != 0)
        return order < 0;
    if (a.hit.surface != b.hit.surface) return a.hit.surface < b.hit.surface;
    return a.hit.root < b.hit.root;
  };
  std::sort(every_.begin(), every_.end(), is_before);
  std::vector<NearestHit> hits;
  for (const Timed& one : every_) hits.push_back(one.hit);
  return hits;
}

NearestHit crossing_hit(const Surfaces& walls, const Ray& ray, std::uint32_t surface, Root root) {
  const HitTime time =
      walls.visit(surface, [&](const auto& wall) { return time_met(wall, ray, root); });
  const HitClass kind = root == Root::none ? HitClass::touch : HitClass::through;
  return {surface, kind, root, false, time.nearest().t};
}

}  // namespace flatray
