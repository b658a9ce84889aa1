#pragma once
#include <vector>

#include "anim/rigid_motion.h"
#include "collide/carried_contact.h"

namespace flatray {

/// The bodies of a scene from one frame to the next, along their true motion; or as one frame shows them.
class FrameBodies {
 public:
  /// Needs   what entities look like in the frame and where they are in the next, or in the frame itself
  ///         where `next_frame` is that one; all outlive it.
  FrameBodies(const Timeline& timeline, Outline outline, unsigned frame, unsigned next_frame,
              std::span<const EntityState> now, std::span<const EntityState> next);

  /// Bodies of those that go straight from frame to frame: t counts frames.
  std::span<const MovingShape> straight() const { return straight_; }
  /// Whether both do, it is their own outlines that meet, and no group carries both.
  bool are_straight(const IndexPair& pair) const;
  /// A box around each on its way.
  std::vector<Bounds> boxes() const;

  /// Times in seconds from frame 1 in which two meet.
  std::vector<MeetingPart> meet(const IndexPair& pair) const;
  /// Makes such times of those that shapes_meet() tells of two.
  void to_seconds(std::vector<MeetingPart>& parts) const;

 private:
  Bounds box_of(std::uint32_t entity) const;
  const Shape* shape(std::uint32_t entity) const;

  const Scene& scene_;
  const TrueMotion motion_;
  const Outline outline_;
  const unsigned frame_;
  const double from_, to_;  // seconds
  const std::span<const EntityState> now_;
  std::vector<MovingShape> straight_;
  std::vector<bool> goes_straight_;
  std::vector<double> doubts_;  // by how far rounding may have moved what goes straight
};

}  // namespace flatray
