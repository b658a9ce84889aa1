#include "collide/body_pairs.h"

#include <algorithm>
#include <cmath>

#include "collide/impact.h"
#include "geom/decide.h"
#include "geom/pair.h"
#include "geom/polygon.h"

namespace flatray {
namespace {

double radius_of(const SimulatedBody& body) {
  double radius = 0;
  for (const ShapePart& part : body.parts)
    for (const Vec2& p : part.ring) radius = std::max(radius, size_of(p) + part.radius);
  return radius * (1 + 0x1p-40);
}

// One more place at which a pair meets. Of one time the first is that whose point is, whichever
// body and part came first.
void add(std::optional<Hit>& met, double time, Touch touch) {
  if (!met || time < met->time) {
    met = Hit{time, touch.pair, {touch}};
    return;
  }
  std::vector<Touch>& all = met->touches;
  if (is_before(touch.place.point, all.front().place.point)) std::swap(touch, all.front());
  const auto alike = [&](const Touch& other) { return other.place.normal == touch.place.normal; };
  if (std::ranges::none_of(all, alike)) all.push_back(touch);
}

}  // namespace

bool approach(const Vec2& normal, const Vec2& a, const Vec2& b) {
  return decide([&](const auto& number) {
           return dot(pair_of(number, normal), pair_of(number, b) - pair_of(number, a));
         }) == Sign::negative;
}

bool is_gentle(const Vec2& normal, const Vec2& a, const Vec2& b) {
  return normal.dot(a - b) <= kSlideLeaves * std::max(a.stableNorm(), b.stableNorm());
}

BodyPairs::BodyPairs(std::span<const SimulatedBody> bodies,
                     const std::vector<std::vector<Stage>>& stages)
    : bodies_(bodies), stages_(stages) {
  for (const SimulatedBody& body : bodies) radii_.push_back(radius_of(body));
}

Vec2 BodyPairs::place(std::uint32_t body, double time) const {
  return place_at(std::span(stages_[body]).last(1), time);
}

MovingBody BodyPairs::part(std::uint32_t body, std::uint32_t part, const Vec2& at,
                           std::vector<Vec2>& ring) const {
  const ShapePart& own = bodies_[body].parts[part];
  ring.clear();
  for (const Vec2& p : own.ring) ring.push_back(at + p);
  mend_convex(ring);
  return {ring, stages_[body].back().velocity, own.radius};
}

// The parts of both, one after the other.
template <class Look>
void BodyPairs::each_contact(const IndexPair& pair, double time, Range within,
                             const Look& look) const {
  const Vec2 at_a = place(pair.first, time), at_b = place(pair.second, time);
  std::vector<Vec2> ring_a, ring_b;
  for (std::uint32_t p = 0; p < bodies_[pair.first].parts.size(); ++p)
    for (std::uint32_t q = 0; q < bodies_[pair.second].parts.size(); ++q) {
      const MovingBody a = part(pair.first, p, at_a, ring_a),
                       b = part(pair.second, q, at_b, ring_b);
      look(contact(a, b, within), a, b, Touch{pair, p, q, {}});
    }
}

bool BodyPairs::overlap(const IndexPair& pair, double time) const {
  bool found = false;
  each_contact(pair, time, {0, 0}, [&](const Contact& met, const auto&...) {
    found |= met.times.start == StartPlace::inside;
  });
  return found;
}

// A time before which discs about both do not meet. What rounding may lose is far below 2^-30 of
// what goes in.
std::optional<double> BodyPairs::least_wait(const IndexPair& pair, double time, double end) const {
  constexpr double kSlack = 0x1p-30, kSmall = 0x1p-900;  // below, lengths have few digits
  const auto [i, k] = pair;
  const Vec2 from = place(k, time) - place(i, time);
  const double distance = size_of(from);
  const double sizes =
      sizes_of_place(stages_[i].back(), time).sum() + sizes_of_place(stages_[k].back(), time).sum();
  const double reach =
      (radii_[i] + radii_[k] + 2 * distance) * kSlack + radii_[i] + radii_[k] + 0x1p-49 * sizes;
  if (!(distance > reach)) return 0;
  const Vec2 way = stages_[k].back().velocity - stages_[i].back().velocity;
  const double speed = size_of(way);
  if (distance < kSmall || (speed > 0 && speed < kSmall) || !(speed < kInfinity)) return 0;
  const double ahead = speed > 0 ? -(way / speed).dot(from) : 0;
  if (!(ahead > 0)) return std::nullopt;
  const double beside = size_of(from + ahead * (way / speed));
  if (beside > reach) return std::nullopt;
  const double inside = beside / reach, soonest = ahead - reach * std::sqrt(1 - inside * inside);
  const double wait = (soonest - kSlack * distance) / speed * (1 - kSlack);
  if (wait > end - time) return std::nullopt;
  return std::max(wait, 0.0);
}

std::optional<Hit> BodyPairs::meeting(const IndexPair& pair, double time, double end,
                                      Overlap overlap) const {
  std::optional<Hit> found;
  bool overlaps = false;
  each_contact(pair, time, kLine, [&](const Contact& met, const auto& a, const auto& b, Touch at) {
    if (met.times.kind != HitClass::through || !met.first || !met.last) return;
    const double enter = met.times.t_enter, t = std::max(enter, 0.0);
    if (met.times.t_exit <= 0 || enter > end - time) return;
    overlaps |= enter < 0;
    if (found && t > found->time) return;
    at.place = enter < 0 ? resting_place(a, b, 0) : contact_place(met.first, a, b, t);
    const Vec2& normal = at.place.normal;
    if (overlap == Overlap::glides && is_gentle(normal, a.velocity, b.velocity)) return;
    if (enter >= 0 || approach(normal, a.velocity, b.velocity)) add(found, t, at);
  });
  if (overlaps && overlap == Overlap::passed) return std::nullopt;
  return found;
}

bool BodyPairs::face(const Touch& touch, double time) const {
  const auto [i, k] = touch.pair;
  std::vector<Vec2> ring_a, ring_b;
  MovingBody a = part(i, touch.part_a, place(i, time), ring_a);
  MovingBody b = part(k, touch.part_b, place(k, time), ring_b);
  a.velocity = {0, 0};
  b.velocity = -touch.place.normal;
  const Contact pressed = contact(a, b, kLine);
  if (pressed.times.kind != HitClass::through || !pressed.first) return false;
  // What is round has then parted by half the square of that, which is less than kSlideLeaves.
  constexpr double kTurned = 0x1p-20;
  const Vec2 normal = contact_place(pressed.first, a, b, 0).normal;
  return (normal - touch.place.normal).cwiseAbs().maxCoeff() <= kTurned;
}

}  // namespace flatray
