#include "transport/moving_hits.h"

#include <algorithm>
#include <utility>

namespace flatray {
namespace {

// As meet_time.h takes it: curved walls that move are circles; scenes refuse others.
const Segment& moved(const Segment& wall) { return wall; }
Circle moved(const Arc& wall) { return circle_of(wall.curve); }

bool is_after(double time, const DoubleDouble& other) {
  return time > other.hi || (time == other.hi && 0 > other.lo);
}

// Hits of some legs of one wall after the other, then of twice as many; the first are kept: no wall is
// followed much longer than until the first hit.
class HitFinder {
 public:
  HitFinder(const MovingWalls& walls, const Mover& mover, const StoodOn& left)
      : walls_(walls), mover_(mover), left_(left) {}

  std::vector<MovingHit> find() && {
    std::vector<std::size_t> next(walls_.world.surfaces.size());
    for (std::uint32_t i = 0; i < next.size(); ++i) {
      const std::vector<Leg>& legs = walls_.legs(i);
      const auto first =
          std::ranges::partition_point(legs, [&](const Leg& leg) { return is_after_end(leg); });
      next[i] = static_cast<std::size_t>(first - legs.begin());
    }
    bool more = true;
    for (std::size_t count = 1; std::exchange(more, false); count *= 2)
      for (std::uint32_t i = 0; i < next.size(); ++i) {
        const std::size_t all = walls_.legs(i).size(),
                          end = next[i] + std::min(count, all - next[i]);
        next[i] = look_at(i, next[i], end) ? all : end;
        more = more || next[i] < all;
      }
    std::ranges::sort(found_, {}, &MovingHit::surface);
    return std::move(found_);
  }

 private:
  // Whether what it comes to in later legs of a wall comes after the first hits.
  bool look_at(std::uint32_t surface, std::size_t begin, std::size_t end) {
    const double gone = walls_.gone_from[walls_.motion_of[surface]];
    for (std::size_t i = begin; i < end; ++i) {
      const Leg& leg = walls_.legs(surface)[i];
      if (leg.begin >= gone) return true;
      if (!found_.empty() && is_after(leg.begin, mover_.since) &&
          compare(MeetTime::at(mover_, leg.begin), found_.front().time) > 0)
        return true;
      const Window window{leg.begin, std::min(leg.end, gone), gone < kInfinity};
      if (walls_.world.surfaces.visit_line_or_arc(
              surface, [&](const auto& wall) { return meets(moved(wall), surface, leg, window); }))
        return true;
    }
    return false;
  }

  // Clock times of a leg; closed but where the wall goes at its end.
  struct Window {
    double begin, end;
    bool goes;
  };

  bool is_after_end(const Leg& leg) const {
    return !leg.is_last() && !is_after(leg.end, mover_.since) && leg.end != mover_.since.hi;
  }

  bool is_in(const MeetTime& time, const Window& window) const {
    if (time.sign() == Sign::negative) return false;
    if (is_after(window.begin, mover_.since) &&
        compare(time, MeetTime::at(mover_, window.begin)) < 0)
      return false;
    if (window.end == kInfinity) return true;
    const auto end = compare(time, MeetTime::at(mover_, window.end));
    return end < 0 || (end == 0 && !window.goes);
  }

  bool keep(const MovingHit& hit) {
    if (!found_.empty()) {
      const auto order = compare(hit.time, found_.front().time);
      if (order > 0) return true;
      if (order < 0) found_.clear();
    }
    found_.push_back(hit);
    return true;
  }

  // Whether it has left a wall in that leg: in a later one it may have gone round its end.
  bool has_left(std::uint32_t surface, const Leg& leg) const {
    return surface == left_.surface && !is_after(leg.begin, mover_.since);
  }

  bool meets(const Segment& wall, std::uint32_t surface, const Leg& leg, const Window& window) {
    const Sign to = heading(mover_, leg, wall);
    if (to == Sign::zero) return meets_end(wall, surface, leg, window);
    if (has_left(surface, leg) && to == left_.side) return false;
    const PlaceOn place = crossing_place(mover_, leg, wall);
    if (place == PlaceOn::outside) return false;
    const MeetTime time = MeetTime::on_line(mover_, leg, wall);
    if (!is_in(time, window)) return false;
    return keep({time, surface, &leg, -to, place == PlaceOn::at_end, Root::first});
  }

  // It moves along the line of the wall, or with the wall.
  bool meets_end(const Segment& wall, std::uint32_t surface, const Leg& leg, const Window& window) {
    if (has_left(surface, leg) || side_of(mover_, leg, wall) != Sign::zero) return false;
    const Sign ahead = decide([&](const auto& number) {
      return dot(pair_of(number, wall.b) - pair_of(number, wall.a),
                 pair_of(number, mover_.velocity) - velocity_of(number, leg));
    });
    if (ahead == Sign::zero) return false;
    for (const bool at_b : {ahead == Sign::negative, ahead == Sign::positive}) {
      const MeetTime time = MeetTime::at_end(mover_, leg, wall, at_b);
      if (is_in(time, window)) return keep({time, surface, &leg, Sign::zero, true, Root::first});
    }
    return false;
  }

  bool meets(const Circle& wall, std::uint32_t surface, const Leg& leg, const Window& window) {
    if (!crosses(mover_, leg, wall)) return false;
    const bool stands = surface == left_.surface;  // and on that side of it, until it meets it
    for (const Root root : {Root::first, Root::second}) {
      const Sign from = root == Root::first ? Sign::positive : Sign::negative;
      if (stands && from != left_.side) continue;
      const MeetTime time = MeetTime::on_circle(mover_, leg, wall, root);
      if (is_in(time, window)) return keep({time, surface, &leg, from, false, root});
    }
    return false;
  }

  const MovingWalls& walls_;
  const Mover& mover_;
  const StoodOn& left_;
  std::vector<MovingHit> found_;  // all at one time
};

Sign side_at(const Segment& wall, const Leg& leg, const Mover& mover, const MeetTime& time) {
  const Sign to = heading(mover, leg, wall);
  if (to == Sign::zero) return side_of(mover, leg, wall);
  return to * sign_of(compare(time, MeetTime::on_line(mover, leg, wall)));
}
Sign side_at(const Circle& wall, const Leg& leg, const Mover& mover, const MeetTime& time) {
  if (!crosses(mover, leg, wall))  // what flies with it may be inside
    return side_of(mover, leg, wall) == Sign::negative ? Sign::negative : Sign::positive;
  const auto in = compare(time, MeetTime::on_circle(mover, leg, wall, Root::first));
  const auto out = compare(time, MeetTime::on_circle(mover, leg, wall, Root::second));
  return in == 0 || out == 0 ? Sign::zero : (in > 0 && out < 0 ? Sign::negative : Sign::positive);
}

}  // namespace

const Leg& leg_at(const std::vector<Leg>& legs, const DoubleDouble& time) {
  const auto after = std::ranges::partition_point(
      legs, [&](const Leg& leg) { return !is_after(leg.begin, time); });
  return after == legs.begin() ? legs.front() : *(after - 1);
}

std::vector<MovingHit> first_hits(const MovingWalls& walls, const Mover& mover,
                                  const StoodOn& left) {
  return HitFinder(walls, mover, left).find();
}

Sign side_at(const MovingWalls& walls, std::uint32_t surface, const Leg& leg, const Mover& mover,
             const MeetTime& time) {
  return walls.world.surfaces.visit_line_or_arc(
      surface, [&](const auto& wall) { return side_at(moved(wall), leg, mover, time); });
}

Sign side_of(const MovingWalls& walls, std::uint32_t surface, const Leg& leg, const Mover& mover) {
  return walls.world.surfaces.visit_line_or_arc(
      surface, [&](const auto& wall) { return side_of(mover, leg, moved(wall)); });
}

Sign heading(const MovingWalls& walls, std::uint32_t surface, const Leg& leg, const Mover& mover) {
  return walls.world.surfaces.visit_line_or_arc(
      surface, [&](const auto& wall) { return heading(mover, leg, moved(wall)); });
}

}  // namespace flatray
