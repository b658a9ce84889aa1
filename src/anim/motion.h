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
};
Placed placed(const Scene& scene, const Vec2& at, double angle, const Motion& motion, double time);

/// Why the frames of a scene differ, or "" when they are all one picture.
std::string reason_to_move(const Scene& scene);
/// The same of the light of lamps alone, whatever else moves.
std::string reason_for_light_to_move(const Scene& scene);

}  // namespace flatray
