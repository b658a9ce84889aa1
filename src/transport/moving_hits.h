#pragma once
#include <optional>

#include "transport/meet_time.h"

namespace flatray {

/// A wall on which a mover stands, on which side of it: left of a segment or outside a circle
/// (positive), or else.
struct StoodOn {
  std::uint32_t surface = kNoSurface;
  Sign side = Sign::zero;
};

/// A mover comes to a wall.
struct MovingHit {
  MeetTime time;
  std::uint32_t surface;
  const Leg* leg;  ///< of its wall
  Sign side;       ///< it comes from
  bool at_end;     ///< exactly at an end of a segment
  Root root;       ///< of a circle
};

/// The leg at a time; at a change the later one.
const Leg& leg_at(const std::vector<Leg>& legs, const DoubleDouble& time);

/// The first walls a mover comes to from Mover::since on: all that it comes to at one time, by
/// number. Exact.
///
/// Needs   what it is made of to outlive the answer.
/// Gives   circles in two points only; a segment along which it moves, at the first end it comes to.
std::vector<MovingHit> first_hits(const MovingWalls& walls, const Mover& mover,
                                  const StoodOn& left);

/// The side of a wall on which a mover is when it meets another; zero on its line. Exact.
Sign side_at(const MovingWalls& walls, std::uint32_t surface, const Leg& leg, const Mover& mover,
             const MeetTime& time);

/// On which side it is at Mover::since. Exact.
Sign side_of(const MovingWalls& walls, std::uint32_t surface, const Leg& leg, const Mover& mover);
/// To which side it moves there, from a point on the wall. Exact.
Sign heading(const MovingWalls& walls, std::uint32_t surface, const Leg& leg, const Mover& mover);

}  // namespace flatray
