#include "transport/moving_orbit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geom/decide.h"
#include "transport/moving_hits.h"
#include "transport/near_doubles.h"
#include "transport/reflection.h"

namespace flatray {
namespace {

// Times beyond it are not told.
constexpr double kLastTime = std::numeric_limits<double>::max();

// Larger than what kSearchUlps and all rounding on the way can move a point, as a part of the
// coordinates that go in.
constexpr double kNear = 0x1p-48;
// Added to those, so that the part also covers what underflow may take away.
constexpr double kSmall = 0x1p-1018;

// A particle under way.
class Flight {
 public:
  Flight(const MovingWalls& walls, const Ray& start, double from, const MovingLimits& limits)
      : walls_(walls),
        materials_(walls.world.materials()),
        limits_(limits),
        mover_{start.origin, start.direction, {from, 0}} {
    done_.orbit.start = start.origin;
    done_.orbit.direction = start.direction;
    done_.velocity = start.direction;
    done_.end_time = from;
  }

  MovingOrbit run() && {
    if (sets_off())
      while (advances()) {
      }
    return std::move(done_);
  }

 private:
  const Leg& leg_now(std::uint32_t surface) const {
    return leg_at(walls_.legs(surface), mover_.since);
  }
  const Surfaces& surfaces() const { return walls_.world.surfaces; }

  // Whether it can set off.
  bool sets_off() {
    std::vector<std::uint32_t> stood_on;
    bool at_end = false;
    for (std::uint32_t i = 0; i < surfaces().size(); ++i)
      if (stands_on(i, at_end)) stood_on.push_back(i);
    if (stood_on.size() > 1 || at_end) return stop(OrbitEnd::corner, std::move(stood_on));
    if (stood_on.size() == 1) {
      left_.surface = stood_on.front();
      left_.side = heading(walls_, left_.surface, leg_now(left_.surface), mover_);
      if (left_.side == Sign::zero && surfaces().segment_slot(left_.surface) != kNoSurface)
        return stop(OrbitEnd::along, std::move(stood_on));
      if (left_.side == Sign::zero) left_.side = Sign::positive;  // along its tangent, or with it
    }
    return limits_.bounces > 0 || stop(OrbitEnd::limit, {});
  }

  bool stands_on(std::uint32_t surface, bool& at_end) const {
    const Leg& leg = leg_now(surface);
    if (mover_.since.hi >= walls_.gone_from[walls_.motion_of[surface]]) return false;
    if (side_of(walls_, surface, leg, mover_) != Sign::zero) return false;
    return surfaces().visit_line_or_arc(
        surface, [&](const auto& wall) { return stands_between_ends(wall, leg, at_end); });
  }
  static bool stands_between_ends(const Arc&, const Leg&, const bool&) { return true; }
  bool stands_between_ends(const Segment& wall, const Leg& leg, bool& at_end) const {
    const auto beyond = [&](const Vec2& end, const Vec2& other) {
      return decide([&](const auto& number) {
        return dot(pair_of(number, other) - pair_of(number, end),
                   relative(number, mover_, leg, end).at);
      });
    };
    const Sign a = beyond(wall.a, wall.b), b = beyond(wall.b, wall.a);
    const bool on = a != Sign::negative && b != Sign::negative;
    at_end |= on && (a == Sign::zero || b == Sign::zero);
    return on;
  }

  // Takes it to its next wall; whether it goes on from there.
  bool advances() {
    const std::vector<MovingHit> hits = first_hits(walls_, mover_, left_);
    if (hits.empty()) return limits_.until < kInfinity ? reaches_end() : stop(OrbitEnd::escape, {});
    const MovingHit& hit = hits.front();
    if (limits_.until < kInfinity && compare(hit.time, MeetTime::at(mover_, limits_.until)) > 0)
      return reaches_end();
    const DoubleDouble clock = hit.time.sum([&](const auto& number, const auto& t) {
      return number(mover_.since.hi) + number(mover_.since.lo) + t;
    });
    if (clock.hi == kLastTime) return reaches_end();
    Mover there{place_at(hit.time), mover_.velocity, clock};
    std::vector<std::uint32_t> met;
    met.reserve(hits.size());
    for (const MovingHit& one : hits) met.push_back(one.surface);
    if (hits.size() > 1 || hit.at_end || materials_[hit.surface] != Material::mirror)
      return arrives(hit, there, std::move(met));
    const std::vector<NearWall> near = near_walls(hit, there);
    const auto stands = nearest_double(there.at, [&](const Vec2& at) {
      return may_stand({at, there.velocity, there.since}, hit, near);
    });
    if (!stands) {
      for (const NearWall& near_wall : near) met.push_back(near_wall.surface);
      std::ranges::sort(met);
      return arrives(hit, there, std::move(met));
    }
    there.at = *stands;
    return bounces(hit, there);
  }

  // Nearest doubles.
  Vec2 place_at(const MeetTime& time) const {
    const auto coordinate = [&](int axis) {
      return time.round([&](const auto& number, const auto& t) {
        return number(mover_.at[axis]) + t * number(mover_.velocity[axis]);
      });
    };
    return {coordinate(0), coordinate(1)};
  }

  // A wall that passes so near that rounding might put the particle on its other side.
  struct NearWall {
    std::uint32_t surface;
    const Leg* leg;
    Sign side;
  };
  std::vector<NearWall> near_walls(const MovingHit& hit, const Mover& there) const {
    std::vector<NearWall> near;
    for (std::uint32_t i = 0; i < surfaces().size(); ++i) {
      if (i == hit.surface || !passes_near(i, there)) continue;
      const Leg& leg = leg_at(walls_.legs(i), there.since);
      const Sign side = side_at(walls_, i, leg, mover_, hit.time);
      if (side != Sign::zero) near.push_back({i, &leg, side});
    }
    return near;
  }

  // In doubles, generously.
  bool passes_near(std::uint32_t surface, const Mover& there) const {
    const Leg& leg = leg_at(walls_.legs(surface), there.since);
    const auto u = velocity_of(kPlain, leg);
    const double elapsed = there.since.hi - leg.begin;
    const Vec2 moved = leg.from + elapsed * Vec2(u.x, u.y);
    const double sizes = there.at.lpNorm<1>() + moved.lpNorm<1>() + leg.from.lpNorm<1>() + kSmall +
                         std::fabs(there.since.hi) * (std::fabs(u.x) + std::fabs(u.y) + kSmall);
    const Vec2 reach = Vec2::Constant(kNear * sizes);
    return surfaces().visit(surface, [&](const auto& wall) {
      return flatray::passes_near(wall, there.at - moved, reach);
    });
  }

  bool may_stand(const Mover& there, const MovingHit& hit,
                 const std::vector<NearWall>& near) const {
    const Leg& own = leg_at(walls_.legs(hit.surface), there.since);
    if (side_of(walls_, hit.surface, own, there) == -hit.side) return false;
    return std::ranges::all_of(near, [&](const NearWall& near_wall) {
      return side_of(walls_, near_wall.surface, *near_wall.leg, there) == near_wall.side;
    });
  }

  // In the frame of the wall the speed stays; here it does not.
  bool bounces(const MovingHit& hit, const Mover& there) {
    const Vec2 off = surfaces().visit_line_or_arc(
        hit.surface, [&](const auto& wall) { return reflected(wall, hit); });
    const auto out = nearest_double(off, [&](const Vec2& velocity) {
      return heading(walls_, hit.surface, *hit.leg, {there.at, velocity, there.since}) == hit.side;
    });
    const Vec2 in = mover_.velocity;
    const Vec2 normal = surfaces().visit_line_or_arc(
        hit.surface, [&](const auto& wall) { return normal_of(wall, hit); });
    const Vec2 towards = static_cast<double>(hit.side) * unit(normal) + Vec2(0, 0);
    const double t = goes_to(hit.time, there);
    left_ = {hit.surface, hit.side};
    if (!out) return stop(OrbitEnd::along, {hit.surface});
    done_.orbit.bounces.push_back({hit.surface, there.at, t, path_, towards, in, *out});
    done_.times.push_back({there.since.hi, wall_velocity(*hit.leg)});
    mover_.velocity = *out;
    done_.velocity = *out;
    done_.end_time = there.since.hi;
    return done_.orbit.bounces.size() < limits_.bounces || stop(OrbitEnd::limit, {});
  }

  // How many seconds that takes.
  double goes_to(const MeetTime& time, const Mover& there) {
    const double t = time.round([](const auto&, const auto& exact) { return exact; });
    path_ += mover_.velocity.stableNorm() * t;
    mover_ = there;
    return t;
  }

  // Nearest doubles, never -0.
  static Vec2 wall_velocity(const Leg& leg) {
    return round_both([&](const auto& number) { return velocity_of(number, leg); }) + Vec2(0, 0);
  }

  // To the left of a segment, outward of a circle.
  static Vec2 normal_of(const Segment& wall, const MovingHit&) {
    return {wall.a.y() - wall.b.y(), wall.b.x() - wall.a.x()};
  }
  Vec2 normal_of(const Arc& wall, const MovingHit& hit) const {
    const auto component = [&](int axis) {
      return hit.time.round([&](const auto& number, const auto& t) {
        const auto n = from_centre(number, t, wall, hit);
        return axis == 0 ? n.x : n.y;
      });
    };
    return {component(0), component(1)};
  }

  // Of the circle of a hit, at a time.
  template <class Make, class Number>
  Pair<Number> from_centre(const Make& number, const Number& t, const Arc& wall,
                           const MovingHit& hit) const {
    const auto seen = relative(number, mover_, *hit.leg, wall.curve.centre);
    return seen.at + t * seen.velocity;
  }

  // Nearest doubles, never -0.
  Vec2 reflected(const Segment& wall, const MovingHit& hit) const {
    return round_both([&](const auto& number) {
             const auto v = pair_of(number, mover_.velocity);
             const auto along = pair_of(number, wall.b) - pair_of(number, wall.a);
             const auto push =
                 number(2.0) * cross(along, velocity_of(number, *hit.leg) - v) / dot(along, along);
             return Pair<decltype(number(0.0))>{v.x - push * along.y, v.y + push * along.x};
           }) +
           Vec2(0, 0);
  }

  // Nearest doubles.
  Vec2 reflected(const Arc& wall, const MovingHit& hit) const {
    const double radius = circle_of(wall.curve).radius;
    const auto component = [&](int axis) {
      return hit.time.round([&](const auto& number, const auto& t) {
        const auto v = pair_of(number, mover_.velocity);
        const auto n = from_centre(number, t, wall, hit);
        const auto push = number(2.0) * dot(velocity_of(number, *hit.leg) - v, n) /
                          (number(radius) * number(radius));
        return axis == 0 ? v.x + push * n.x : v.y + push * n.y;
      });
    };
    return {component(0), component(1)};
  }

  // At what does not reflect it.
  bool arrives(const MovingHit& hit, const Mover& there, std::vector<std::uint32_t> met) {
    goes_to(hit.time, there);
    std::vector<std::uint32_t> takers = taken_by(materials_, met);
    return takers.empty() ? stop(OrbitEnd::corner, std::move(met))
                          : stop(OrbitEnd::absorbed, std::move(takers));
  }

  bool reaches_end() {
    const double end = std::min(limits_.until, kLastTime);
    mover_.at = place_at(MeetTime::at(mover_, end));
    mover_.since = {end, 0};
    return stop(OrbitEnd::limit, {});
  }

  bool stop(OrbitEnd end, std::vector<std::uint32_t> surfaces) {
    const bool moves = mover_.velocity != Vec2(0, 0);
    static_cast<OrbitStop&>(done_.orbit) = {end, moves ? unit(mover_.velocity) : Vec2(0, 0),
                                            mover_.at, std::move(surfaces)};
    done_.velocity = mover_.velocity;
    done_.end_time = mover_.since.hi;
    return false;
  }

  const MovingWalls& walls_;
  const std::vector<Material> materials_;
  const MovingLimits limits_;
  Mover mover_;
  StoodOn left_;
  double path_ = 0;
  MovingOrbit done_;
};

}  // namespace

MovingOrbit trace_moving_orbit(const MovingWalls& walls, const Ray& start, double from,
                               const MovingLimits& limits) {
  return Flight(walls, start, from, limits).run();
}

Vec2 at_speed(const Vec2& direction, double speed) {
  const Vec2 near_one = Speed(direction).near_one(direction);
  return near_one * speed / near_one.norm();
}

}  // namespace flatray
