#include "anim/rays.h"

#include <algorithm>
#include <cmath>

#include "anim/motion.h"
#include "geom/turn.h"
#include "scene/curve.h"

namespace flatray {
namespace {

// A ray of a fan before it moves: seen from where the fan stands, which looks along x as written.
Ray in_fan(const Scene& scene, const RayPath& ray, const Vec2& d, double time) {
  if (!ray.fan) return {{0, 0}, d};
  const double size = std::max(std::fabs(d.x()), std::fabs(d.y()));
  const Vec2 along = d / size, left = Vec2(-along.y(), along.x()) / std::sqrt(along.dot(along));
  const Turn by = turn(ray.fan->place * plus(scene, ray.fan->spread, time));
  return {ray.fan->place * plus(scene, ray.fan->width, time) * left,
          {by.cos * d.x() - by.sin * d.y(), by.sin * d.x() + by.cos * d.y()}};
}

RayState state_of(const Scene& scene, std::uint32_t number, const Vec2& direction, double time,
                  const std::vector<GroupPose>& groups) {
  const RayPath& ray = scene.rays[number];
  const Placed now = placed(scene, ray, time);
  const Ray own = in_fan(scene, ray, direction, time);
  const double turned = now.angle + ray.angular_velocity * time;
  const Vec2 start = pose(held(now.at + ray.velocity * time), turned)(own.origin);
  const auto [at, angle, scale] = in_world(held(start), turned, ray.group, groups);
  Stroke stroke = ray.stroke;
  stroke.width = plus(scene, stroke.width, stroke.width_curve, time);
  stroke.scale = scale;
  return {number,
          {at, pose({0, 0}, angle).turned(own.direction)},
          scale,
          stroke,
          plus(scene, ray.opacity, time)};
}

}  // namespace

std::vector<RayState> ray_states(const Scene& scene, double time) {
  std::vector<RayState> states;
  if (scene.rays.empty()) return states;
  const std::vector<GroupPose> groups = group_poses(scene, time);
  for (std::uint32_t i = 0; i < scene.rays.size(); ++i) {
    const Vec2 direction = plus(scene, scene.rays[i].direction, time);
    if (direction == Vec2(0, 0)) continue;
    states.push_back(state_of(scene, i, direction, time, groups));
  }
  return states;
}

std::vector<RayState> ray_states(const Scene& scene, const FrameState& state) {
  std::vector<RayState> states = ray_states(scene, state.time);
  const Pose world = world_pose(state);
  for (RayState& ray : states) ray.start.origin = world(ray.start.origin);
  return states;
}

bool moves(const RayPath& ray) {
  const bool fan_moves = ray.fan && (ray.fan->spread.curve || ray.fan->width.curve);
  return ray.changes_place() || ray.direction.x || ray.direction.y || fan_moves ||
         ray.opacity.curve || ray.stroke.width_curve || ray.stroke.colour.curve != kNoEntry;
}

}  // namespace flatray
