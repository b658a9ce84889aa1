#include "anim/motion.h"

#include <algorithm>

namespace flatray {
namespace {

bool moves(const Group& group) { return !group.velocity.isZero(0) || group.angular_velocity != 0; }

bool moves(const Entity& entity) {
  return entity.markov || !entity.velocity.isZero(0) || entity.angular_velocity != 0;
}

}  // namespace

// So written that a NaN is held, too.
Vec2 held(const Vec2& point) {
  const auto within = [](double v) {
    return v > -kFarthest ? (v < kFarthest ? v : kFarthest) : -kFarthest;
  };
  return {within(point.x()), within(point.y())};
}

std::vector<GroupPose> group_poses(const Scene& scene, double time) {
  std::vector<GroupPose> poses;
  poses.reserve(scene.groups.size());
  for (const Group& group : scene.groups) {
    Vec2 at = held(group.at + group.velocity * time);
    double angle = group.angle + group.angular_velocity * time;
    if (group.group) {
      at = held(poses[*group.group].pose(at));
      angle += poses[*group.group].angle;
    }
    poses.push_back({pose(at, angle), angle});
  }
  return poses;
}

std::string reason_to_move(const Scene& scene) {
  if (scene.frames == 1) return {};
  if (!scene.camera.velocity.isZero(0)) return "the camera moves";
  for (const Entity& entity : scene.entities) {
    if (moves(entity)) return "'" + entity.name + "' moves";
    for (auto at = entity.group; at; at = scene.groups[*at].group)
      if (moves(scene.groups[*at])) return "group '" + scene.groups[*at].name + "' moves";
  }
  return {};
}

}  // namespace flatray
