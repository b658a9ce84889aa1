#include "anim/moving_walls.h"

#include <algorithm>

#include "anim/motion.h"

namespace flatray {
namespace {

void add_times(const Scene& scene, const Motion& motion, std::vector<double>& times) {
  for (const std::optional<CurveId>& curve : {motion.x, motion.y})
    if (curve)
      for (const double time : scene.curves[*curve].times)
        if (time > 0) times.push_back(time);
}

// 0, and all later times at which its velocity changes.
std::vector<double> knot_times(const Scene& scene, const Entity& entity) {
  std::vector<double> times{0};
  add_times(scene, entity.motion, times);
  for (auto at = entity.group; at; at = scene.groups[*at].group)
    add_times(scene, scene.groups[*at].motion, times);
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

Vec2 place_of(const Scene& scene, const Entity& entity, double time) {
  const Placed now = placed(scene, entity, time);
  const Vec2 at = held(now.at + entity.velocity * time);
  return entity.group ? held(group_poses(scene, time)[*entity.group].pose(at)) : at;
}

// In the world, where all curves have come to their ends.
Vec2 last_velocity(const Scene& scene, const Entity& entity) {
  Vec2 velocity = entity.velocity;
  for (auto at = entity.group; at; at = scene.groups[*at].group) {
    const Group& group = scene.groups[*at];
    velocity = pose({0, 0}, group.angle, group.scale.value).turned(velocity) + group.velocity;
  }
  return velocity;
}

std::vector<Leg> join(std::vector<Leg> legs) {
  for (std::size_t i = 0; i + 1 < legs.size(); ++i) {
    legs[i].end = legs[i + 1].begin;
    legs[i].to = legs[i + 1].from;
  }
  return legs;
}

std::vector<Leg> legs_of(const Scene& scene, const Entity& entity) {
  std::vector<Leg> legs;
  for (const double time : knot_times(scene, entity))
    legs.push_back({time, kInfinity, place_of(scene, entity, time), {0, 0}, {0, 0}});
  legs.back().velocity = last_velocity(scene, entity);
  return join(std::move(legs));
}

// What contact has made of its motion: of stages that begin at one time the last counts.
std::vector<Leg> legs_of(std::span<const Stage> stages) {
  std::vector<Leg> legs;
  for (const Stage& stage : stages) {
    if (!legs.empty() && legs.back().begin == stage.from) legs.pop_back();
    legs.push_back({stage.from, kInfinity, stage.at, {0, 0}, stage.velocity});
  }
  return join(std::move(legs));
}

double gone_from(std::span<const Stage> stages) {
  for (const Stage& stage : stages)
    if (stage.gone) return stage.from;
  return kInfinity;
}

bool stays(const std::vector<Leg>& legs) {
  return legs.back().velocity.isZero(0) &&
         std::ranges::all_of(legs, [&](const Leg& leg) { return leg.from == legs.front().from; });
}

}  // namespace

MovingWalls moving_walls(const Timeline& timeline) {
  const Scene& scene = timeline.scene();
  FrameState state{1, 0, entity_states(timeline, 1), {}, {}, {0, 0}};
  MovingWalls walls{{}, {{Leg{}}}, {}, {kInfinity}};
  std::vector<std::uint32_t> by_entity(scene.entities.size(), 0);
  for (std::uint32_t i = 0; i < scene.entities.size(); ++i) {
    if (!scene.entities[i].material) continue;
    const std::span<const Stage> stages = timeline.stages(i);
    std::vector<Leg> legs = stages.empty() ? legs_of(scene, scene.entities[i]) : legs_of(stages);
    const double gone = gone_from(stages);
    if (stays(legs) && gone == kInfinity) continue;
    by_entity[i] = static_cast<std::uint32_t>(walls.motions.size());
    walls.motions.push_back(std::move(legs));
    walls.gone_from.push_back(gone);
    state.entities[i].at = {0, 0};
    state.entities[i].gone = false;
  }
  walls.world = build_world(scene, state);
  for (const SurfaceOwner& owner : walls.world.owners)
    walls.motion_of.push_back(owner.kind == SurfaceOwner::Kind::entity ? by_entity[owner.index]
                                                                       : 0);
  return walls;
}

}  // namespace flatray
