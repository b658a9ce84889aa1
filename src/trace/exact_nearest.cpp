#include "trace/exact_nearest.h"

#include <algorithm>
#include <cmath>

#include "geom/error_bounds.h"
#include "trace/on_surface.h"

namespace flatray {
namespace {

// Whether a ray surely misses a circle: its line passes the centre at more than the radius, or all
// of the circle lies behind. Products d x w and d.w, w = centre - origin, are known to kDetFilter
// of their terms; 2^-48 covers the rounding of |d|, of the products with it and of the comparison.
// Outside the guarded sizes nothing is sure.
bool surely_missed(const Ray& ray, const Circle& circle) {
  const Vec2& d = ray.direction;
  const Vec2 w = circle.centre - ray.origin;
  const double square = d.x() * d.x() + d.y() * d.y();
  const double terms =
      (std::fabs(d.x()) + std::fabs(d.y())) * (std::fabs(w.x()) + std::fabs(w.y()));
  if (!(square > kDetFilterLeast && terms > kDetFilterLeast && terms < 1 / kDetFilterLeast))
    return false;
  const double reach = circle.radius * std::sqrt(square) * (1 + 0x1p-48) + 2 * kDetFilter * terms;
  return std::fabs(cross(d, w)) > reach || -d.dot(w) > reach;
}

}  // namespace

ExactNearest::ExactNearest(const Surfaces& walls, const Ray& ray, const Left& left, bool tangents)
    : walls_(walls),
      ray_(ray),
      left_(left),
      tangents_(tangents),
      point_test_(ray.direction == Vec2(0, 0)) {}

void ExactNearest::offer(const NearestHit& hit, const HitTime& time) {
  if (time.sign() == Sign::negative) return;
  if (every_ != nullptr) {
    every_->push_back({hit, time});
    return;
  }
  if (best_time_) {
    const std::strong_ordering order = compare(time, *best_time_);
    if (order > 0 || (order == 0 && hit.surface > best_.surface)) return;
  }
  best_ = hit;
  best_time_ = time;
}

void ExactNearest::offer_point_test(std::uint32_t number, bool on_it, bool at_end) {
  if (!on_it) return;
  const NearestHit hit{number, HitClass::touch, Root::none, at_end, 0};
  if (every_ != nullptr)
    every_->push_back({hit, std::nullopt});
  else if (number <= best_.surface)
    best_ = hit;
}

// When the ray is level with a point: the perpendicular through the point is a line it always
// crosses.
HitTime ExactNearest::time_abreast_of(const Vec2& point) const {
  return HitTime::on_line(ray_, point, {0, 0}, {-ray_.direction.y(), ray_.direction.x()});
}

void ExactNearest::offer_along(const Segment& segment, std::uint32_t number) {
  const HitTime a = time_abreast_of(segment.a), b = time_abreast_of(segment.b);
  const auto [near, far] = compare(a, b) <= 0 ? std::pair(a, b) : std::pair(b, a);
  if (far.sign() == Sign::negative) return;
  const bool ends_here = far.sign() == Sign::zero;
  const bool at_end = ends_here || near.sign() != Sign::negative;
  const HitClass kind = ends_here || compare(near, far) == 0 ? HitClass::touch : HitClass::along;
  offer({number, kind, Root::none, at_end, 0},
        at_end && !ends_here ? near : time_abreast_of(ray_.origin));
}

void ExactNearest::offer_segment(std::size_t slot) {
  const std::uint32_t number = walls_.segment_numbers[slot];
  if (number == left_.surface) return;
  const Segment& segment = walls_.segments[slot];
  if (point_test_)
    return offer_point_test(number, lies_on(ray_.origin, segment),
                            ray_.origin == segment.a || ray_.origin == segment.b);
  if (const auto met = hit_segment(ray_, segment)) {
    const bool at_end = met->place != SegmentHit::Place::inner;
    offer({number, HitClass::touch, Root::none, at_end, 0}, met->t);
  } else if (side_of_ray(ray_, segment.a) == Sign::zero &&
             side_of_ray(ray_, segment.b) == Sign::zero) {
    offer_along(segment, number);
  }
}

void ExactNearest::offer_circle(std::size_t slot) {
  const std::uint32_t number = walls_.circle_numbers[slot];
  const Root stood_on = number == left_.surface ? left_.root : Root::none;
  if (stood_on == Root::both) return;
  const Circle& circle = walls_.circles[slot];
  if (point_test_)
    return offer_point_test(number, circle_side(ray_.origin, circle) == Sign::zero, false);
  if (surely_missed(ray_, circle)) return;
  const auto met = hit_circle(ray_, circle);
  if (!met) return;
  if (met->tangent) {
    if (tangents_ && stood_on == Root::none)
      offer({number, HitClass::touch, Root::both, false, 0}, met->first);
    return;
  }
  const bool enters = stood_on != Root::first && met->first.sign() != Sign::negative;
  if (enters) offer({number, HitClass::through, Root::first, false, 0}, met->first);
  if ((!enters || every_ != nullptr) && stood_on != Root::second)
    offer({number, HitClass::through, Root::second, false, 0}, met->second);
}

void ExactNearest::offer_segments() {
  for (std::size_t i = 0; i < walls_.segments.size(); ++i) offer_segment(i);
}

void ExactNearest::offer_circles() {
  for (std::size_t i = 0; i < walls_.circles.size(); ++i) offer_circle(i);
}

void ExactNearest::offer(std::uint32_t surface) {
  switch (walls_.kinds[surface]) {
    case SurfaceKind::segment:
      return offer_segment(walls_.slot[surface]);
    case SurfaceKind::circle:
      return offer_circle(walls_.slot[surface]);
  }
}

NearestHit ExactNearest::hit() const {
  NearestHit hit = best_;
  if (best_time_) hit.t = best_time_->nearest().t;
  return hit;
}

ExactHits::ExactHits(const Surfaces& walls, const Ray& ray, const Left& left, bool tangents)
    : search_(walls, ray, left, tangents) {
  search_.every_ = &every_;
}

// Rounding keeps order, so that exact times are compared only where the doubles are equal.
std::vector<NearestHit> ExactHits::hits() {
  for (ExactNearest::Timed& one : every_)
    if (one.time) one.hit.t = one.time->nearest().t;
  const auto is_before = [](const ExactNearest::Timed& a, const ExactNearest::Timed& b) {
    if (a.hit.t != b.hit.t) return a.hit.t < b.hit.t;
    if (a.time && b.time)
      if (const std::strong_ordering order = compare(*a.time, *b.time); order != 0)
        return order < 0;
    if (a.hit.surface != b.hit.surface) return a.hit.surface < b.hit.surface;
    return a.hit.root < b.hit.root;
  };
  std::sort(every_.begin(), every_.end(), is_before);
  std::vector<NearestHit> hits;
  for (const ExactNearest::Timed& one : every_) hits.push_back(one.hit);
  return hits;
}

NearestHit crossing_hit(const Surfaces& walls, const Ray& ray, std::size_t slot) {
  const double t = HitTime::on_line(ray, walls.segments[slot]).nearest().t;
  return {walls.segment_numbers[slot], HitClass::touch, Root::none, false, t};
}

}  // namespace flatray
