#include "trace/exact_nearest.h"

#include <algorithm>
#include <cmath>

#include "geom/error_bounds.h"
#include "geom/exact_hit.h"
#include "trace/on_surface.h"

namespace flatray {
namespace {

// Whether a ray surely misses all that is within `reach` of `centre`: its line passes at more than
// that, or all of it lies behind. Products d x w and d.w, w = centre - origin, are known to
// kDetFilter of their terms; 2^-48 covers the rounding of |d|, of the products with it and of the
// comparison. Outside the guarded sizes nothing is sure.
bool surely_missed(const Ray& ray, const Vec2& centre, double reach) {
  const Vec2& d = ray.direction;
  const Vec2 w = centre - ray.origin;
  const double square = d.x() * d.x() + d.y() * d.y();
  const double terms =
      (std::fabs(d.x()) + std::fabs(d.y())) * (std::fabs(w.x()) + std::fabs(w.y()));
  if (!(square > kDetFilterLeast && terms > kDetFilterLeast && terms < 1 / kDetFilterLeast))
    return false;
  const double bound = reach * std::sqrt(square) * (1 + 0x1p-48) + 2 * kDetFilter * terms;
  return std::fabs(cross(d, w)) > bound || -d.dot(w) > bound;
}

// No point of the arc is farther from its centre, joints to its ends included.
double reach_of(const Arc& arc) {
  const Ellipse& curve = arc.curve;
  const auto size = [](const Vec2& v) { return std::fabs(v.x()) + std::fabs(v.y()); };
  double reach = curve.is_circle() ? curve.u.x() : size(curve.u) + size(curve.v);
  if (arc.extent == Arc::Extent::between)
    reach = std::max({reach, size(arc.from - curve.centre), size(arc.to - curve.centre)});
  return reach * (1 + 0x1p-48);
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

void ExactNearest::offer_along(const Segment& segment, std::uint32_t number) {
  const HitTime a = HitTime::abreast(ray_, segment.a), b = HitTime::abreast(ray_, segment.b);
  const auto [near, far] = compare(a, b) <= 0 ? std::pair(a, b) : std::pair(b, a);
  if (far.sign() == Sign::negative) return;
  const bool ends_here = far.sign() == Sign::zero;
  const bool at_end = ends_here || near.sign() != Sign::negative;
  const HitClass kind = ends_here || compare(near, far) == 0 ? HitClass::touch : HitClass::along;
  offer({number, kind, Root::none, at_end, 0},
        at_end && !ends_here ? near : HitTime::abreast(ray_, ray_.origin));
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

void ExactNearest::offer_curve(std::uint32_t number) {
  const Arc arc = walls_.arc(number);
  if (number == left_.surface && left_.root == Root::both) return;
  if (point_test_) {
    const ArcPlace place = place_on(arc, ray_.origin);
    return offer_point_test(number, place != ArcPlace::outside, place == ArcPlace::at_end);
  }
  if (surely_missed(ray_, arc.curve.centre, reach_of(arc))) return;
  if (arc.extent == Arc::Extent::between)
    for (const Vec2& end : {arc.from, arc.to})
      if (const auto time = hit_joint(ray_, arc.curve, end))
        offer({number, HitClass::touch, Root::none, true, 0}, *time);
  if (const auto met = hit_curve(ray_, arc.curve)) offer_root(number, arc, *met);
}

// The first root ahead that is on the arc.
void ExactNearest::offer_root(std::uint32_t number, const Arc& arc, const CurveHit& met) {
  const Root stood_on = number == left_.surface ? left_.root : Root::none;
  const auto place = [&](HitTime::Root root) {
    return arc.extent == Arc::Extent::whole ? ArcPlace::inner
                                            : ExactHit(ray_, arc.curve, root).place_in(arc);
  };
  if (met.tangent) {
    const bool passed_by = !tangents_ && arc.extent == Arc::Extent::whole;
    if (passed_by || stood_on != Root::none || met.first.sign() == Sign::negative) return;
    const ArcPlace there = place(HitTime::Root::first);
    if (there == ArcPlace::at_end || (tangents_ && there == ArcPlace::inner))
      offer({number, HitClass::touch, Root::both, there == ArcPlace::at_end, 0}, met.first);
    return;
  }
  for (const Root root : {Root::first, Root::second}) {
    const bool first = root == Root::first;
    const HitTime& time = first ? met.first : met.second;
    if (stood_on == root || time.sign() == Sign::negative) continue;
    const ArcPlace there = place(first ? HitTime::Root::first : HitTime::Root::second);
    if (there == ArcPlace::outside) continue;
    offer({number, HitClass::through, root, there == ArcPlace::at_end, 0}, time);
    if (every_ == nullptr) return;
  }
}

void ExactNearest::offer_segments() {
  for (std::size_t i = 0; i < walls_.segments.size(); ++i) offer_segment(i);
}

void ExactNearest::offer_curves() {
  for (const std::uint32_t number : walls_.circle_numbers) offer_curve(number);
  for (const std::uint32_t number : walls_.arc_numbers) offer_curve(number);
}

void ExactNearest::offer(std::uint32_t surface) {
  switch (walls_.kinds[surface]) {
    case SurfaceKind::segment:
      return offer_segment(walls_.slot[surface]);
    case SurfaceKind::circle:
    case SurfaceKind::arc:
      return offer_curve(surface);
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

NearestHit crossing_hit(const Surfaces& walls, const Ray& ray, std::uint32_t surface, Root root) {
  const HitTime time =
      HitTime::on_curve(ray, walls.curve(surface),
                        root == Root::first ? HitTime::Root::first : HitTime::Root::second);
  return {surface, HitClass::through, root, false, time.nearest().t};
}

}  // namespace flatray
