#include "anim/motion.h"

#include <algorithm>

#include "anim/lamps.h"
#include "anim/rays.h"
#include "base/portable_math.h"
#include "scene/curve.h"
#include "scene/responses.h"

namespace flatray {
namespace {

bool changes(const Stroke& stroke) { return stroke.width_curve || stroke.colour.curve != kNoEntry; }

bool moves(const Scene& scene, const Entity& entity) {
  return entity.markov || entity.changes_place() || entity.opacity.curve ||
         (entity.fill && entity.fill->curve != kNoEntry) ||
         (entity.stroke && changes(*entity.stroke)) ||
         scene.shapes[entity.shape].changes != kNoEntry;
}

// As moves() of the groups that something stands in.
std::string reason_of_groups(const Scene& scene, std::optional<std::uint32_t> group) {
  for (; group; group = scene.groups[*group].group)
    if (moves(scene.groups[*group])) return "group '" + scene.groups[*group].name + "' moves";
  return {};
}

bool moves(const Camera& camera) {
  return (camera.at && (camera.at->x || camera.at->y)) || (camera.height && camera.height->curve) ||
         camera.zoom.curve || !camera.velocity.isZero(0);
}

}  // namespace

Placed placed(const Scene& scene, const Movable& thing, double time) {
  const Motion& motion = thing.motion;
  Placed now{plus(scene, MovingPoint{thing.at, motion.x, motion.y}, time),
             plus(scene, thing.angle, motion.angle, time)};
  if (!motion.follow) return now;
  const auto& [path, speed, duration, start, turn] = *motion.follow;
  const PathPoint point = point_at(scene.paths[path], start + speed * (time / duration));
  now.at += point.at;
  if (turn) now.angle += portable::atan2(point.direction.y(), point.direction.x());
  return now;
}

Placed in_world(const Vec2& at, double angle, std::optional<std::uint32_t> group,
                std::span<const GroupPose> groups) {
  if (!group) return {at, angle};
  const GroupPose& outer = groups[*group];
  return {held(outer.pose(at)), angle + outer.angle, outer.pose.scale};
}

std::vector<GroupPose> group_poses(const Scene& scene, double time) {
  std::vector<GroupPose> poses;
  poses.reserve(scene.groups.size());
  for (const Group& group : scene.groups) {
    const Placed now = placed(scene, group, time);
    Vec2 at = held(now.at + group.velocity * time);
    double angle = now.angle + group.angular_velocity * time;
    double scale = plus(scene, group.scale, time);
    if (group.scale.curve) scale = std::max(scale, 1 / kFarthest);
    if (group.group) {
      at = held(poses[*group.group].pose(at));
      angle += poses[*group.group].angle;
      scale = std::max(held(scale * poses[*group.group].pose.scale), 1 / kFarthest);
    }
    poses.push_back({pose(at, angle, scale), angle});
  }
  return poses;
}

namespace {

std::string reason_of(const Scene& scene, const Entity& entity) {
  if (moves(scene, entity)) return called("entity", entity.name, entity.where) + " moves";
  return reason_of_groups(scene, entity.group);
}

std::string reason_of_lamps(const Scene& scene) {
  for (const Lamp& lamp : scene.lamps) {
    if (moves(lamp)) return called("lamp", lamp.name, lamp.where) + " moves";
    if (auto reason = reason_of_groups(scene, lamp.group); !reason.empty()) return reason;
  }
  return !scene.lamps.empty() && scene.light.noise_moves ? "the noise of light moves" : "";
}

}  // namespace

std::string reason_to_move(const Scene& scene) {
  if (moves(scene.camera)) return "the camera moves";
  for (const RayPath& ray : scene.rays) {
    if (ray.ball || ray.speed)
      return std::string(ray.ball ? "a ball" : "a ray") + " goes along " +
             called("ray", ray.name, ray.where);
    if (moves(ray)) return called("ray", ray.name, ray.where) + " moves";
    if (auto reason = reason_of_groups(scene, ray.group); !reason.empty()) return reason;
  }
  for (const Entity& entity : scene.entities)
    if (auto reason = reason_of(scene, entity); !reason.empty()) return reason;
  if (scene.collisions && scene.collisions->time_bar) return "the mark of the time bar moves";
  return reason_of_lamps(scene);
}

std::string reason_for_light_to_move(const Scene& scene) {
  if (moves(scene.camera) || scene.camera.follow) return "the camera moves";
  if (responds(scene)) return "what responds to contact may move";
  for (const Entity& entity : scene.entities)
    if (entity.material)
      if (auto reason = reason_of(scene, entity); !reason.empty()) return reason;
  return reason_of_lamps(scene);
}

}  // namespace flatray
