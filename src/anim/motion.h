#pragma once
#include "anim/frame_state.h"

namespace flatray {

/// Poses of all groups in the world at `time`, by number: what stands in them is seen from there.
struct GroupPose {
  Pose pose;
  double angle = 0;
};
std::vector<GroupPose> group_poses(const Scene& scene, double time);

/// Where a thing stands in its group, and at which angle, but for its velocities.
struct Placed {
  Vec2 at;
  double angle;
  double scale = 1;  ///< of the groups it stands in
};
Placed placed(const Scene& scene, const Movable& thing, double time);

/// The same in the world, of what stands at `at` in a group, or in none.
Placed in_world(const Vec2& at, double angle, std::optional<std::uint32_t> group,
                std::span<const GroupPose> groups);

/// Why the frames of a scene differ, or "" when they are all one picture.
std::string reason_to_move(const Scene& scene);
/// The same of the light of lamps alone, whatever else moves.
std::string reason_for_light_to_move(const Scene& scene);

}  // namespace flatray
