#include "anim/frame_state.h"

#include "anim/camera.h"
#include "anim/motion.h"
#include "geom/polygon.h"
#include "geom/turn.h"
#include "scene/curve.h"
#include "scene/keys/changing_shape.h"

namespace flatray {
namespace {

double time_of(const Scene& scene, unsigned frame) { return (frame - 1.0) / scene.fps; }

void apply(const Look& look, EntityState& state) {
  if (look.shape) state.shape = *look.shape;
  if (look.fill) state.fill = look.fill;
  if (look.stroke) state.stroke = look.stroke;
}

// As seen from its group.
EntityState local_state(const Timeline& timeline, std::uint32_t index, unsigned frame,
                        double time) {
  const Scene& scene = timeline.scene();
  const Entity& entity = scene.entities[index];
  const Placed now = placed(scene, entity, time);
  EntityState state{.at = now.at,
                    .angle = now.angle + entity.angular_velocity * time,
                    .shape = entity.shape,
                    .fill = entity.fill,
                    .stroke = entity.stroke,
                    .opacity = plus(scene, entity.opacity, time),
                    .state = std::nullopt};
  if (!entity.markov) {
    state.at = held(state.at + entity.velocity * time);
    return state;
  }
  const Timeline::MarkovFrame walk = timeline.markov(index, frame);
  state.at = held(state.at + walk.moved);
  if (const double part = time * scene.fps - (frame - 1.0);
      part > 0 && time > time_of(scene, frame))
    state.at += part * (timeline.markov(index, frame + 1).moved - walk.moved);
  state.state = walk.state;
  state.sub_state = walk.sub_state;
  const auto& looks = entity.markov->looks;
  if (walk.state < looks.size() && walk.sub_state < looks[walk.state].size())
    apply(looks[walk.state][walk.sub_state], state);
  return state;
}

EntityState entity_state(const Timeline& timeline, std::uint32_t index, unsigned frame, double time,
                         std::span<const GroupPose> groups) {
  EntityState state = local_state(timeline, index, frame, time);
  if (state.stroke)
    state.stroke->width =
        plus(timeline.scene(), state.stroke->width, state.stroke->width_curve, time);
  const Placed there =
      in_world(state.at, state.angle, timeline.scene().entities[index].group, groups);
  state.at = there.at, state.angle = there.angle, state.scale = there.scale;
  if (state.stroke) state.stroke->scale = state.scale;
  if (const std::span<const Stage> stages = timeline.stages(index); !stages.empty()) {
    state.at = held(place_at(stages, time));
    state.gone = stage_at(stages, time).gone;
  }
  return state;
}

// Each once, however many share it.
void change_shapes(const Scene& scene, double time, std::vector<EntityState>& states) {
  std::vector<std::shared_ptr<const Shape>> now(scene.changing_shapes.size());
  for (EntityState& state : states) {
    const std::uint32_t changes = scene.shapes[state.shape].changes;
    if (changes == kNoEntry) continue;
    std::shared_ptr<const Shape>& shape = now[changes];
    if (!shape)
      shape = std::make_shared<Shape>(shape_at(scene, scene.changing_shapes[changes], time));
    state.changed = shape;
  }
}

std::vector<Timeline::MarkovFrame> lamp_walks(const Timeline& timeline, unsigned frame) {
  const std::vector<Lamp>& lamps = timeline.scene().lamps;
  std::vector<Timeline::MarkovFrame> walks;
  for (std::uint32_t i = 0; i < lamps.size(); ++i) {
    if (!lamps[i].markov) continue;
    walks.resize(lamps.size());
    walks[i] = timeline.lamp(i, frame);
  }
  return walks;
}

Bounds window_at(const Timeline& timeline, unsigned frame) {
  const double time = time_of(timeline.scene(), frame);
  const std::optional<std::uint32_t> follow = timeline.scene().camera.follow;
  if (!follow) return camera_window(timeline, time, {0, 0});
  const std::vector<GroupPose> groups = group_poses(timeline.scene(), time);
  return camera_window(timeline, time, entity_state(timeline, *follow, frame, time, groups).at);
}

}  // namespace

std::vector<EntityState> entity_states(const Timeline& timeline, unsigned frame, double part) {
  const double time = (frame - 1.0 + part) / timeline.scene().fps;
  const std::vector<GroupPose> groups = group_poses(timeline.scene(), time);
  std::vector<EntityState> states;
  states.reserve(timeline.scene().entities.size());
  for (std::uint32_t i = 0; i < timeline.scene().entities.size(); ++i)
    states.push_back(entity_state(timeline, i, frame, time, groups));
  if (!timeline.scene().changing_shapes.empty()) change_shapes(timeline.scene(), time, states);
  return states;
}

FrameState at(const Timeline& timeline, unsigned frame) {
  FrameState state{.frame = frame,
                   .time = time_of(timeline.scene(), frame),
                   .entities = entity_states(timeline, frame),
                   .lamps = lamp_walks(timeline, frame),
                   .window = window_at(timeline, frame)};
  if (timeline.scene().camera.motion == CameraMotion::objects) {
    const Bounds first = window_at(timeline, 1);
    state.displaced = first.low - state.window.low;
    const Camera& camera = timeline.scene().camera;
    const Vec2 size = state.window.size();
    state.window = first;
    if ((camera.height && camera.height->curve) || camera.zoom.curve)
      state.window.high = first.low + size;
  }
  return state;
}

Pose pose(const Vec2& at, double angle, double scale) {
  const Turn turned = turn(angle);
  return {at, turned.cos, turned.sin, scale};
}

Pose entity_pose(const FrameState& state, std::size_t entity) {
  const EntityState& placed = state.entities[entity];
  return pose(placed.at + state.displaced, placed.angle, placed.scale);
}

Pose pillar_pose(const FrameState& state, const Chamber::Pillar& pillar) {
  return pose(pillar.at + state.displaced, pillar.angle);
}

Pose world_pose(const FrameState& state) { return {state.displaced}; }

std::vector<Vec2> posed_piece(const Shape& shape, std::size_t piece, const Pose& place) {
  std::vector<Vec2> vertices;
  for (std::uint32_t i = shape.begin[piece]; i < shape.begin[piece + 1]; ++i)
    vertices.push_back(place(shape.vertices[i]));
  mend_convex(vertices);
  return vertices;
}

Circle posed(const Circle& circle, const Pose& place) {
  return {place(circle.centre), place.length(circle.radius)};
}

ArcPath posed(ArcPath path, const Pose& place) {
  path.radius = place.length(path.radius);
  for (EllipseArc& arc : path.arcs) {
    arc.centre = place(arc.centre);
    arc.u = place.turned(arc.u);
    arc.v = place.turned(arc.v);
  }
  return path;
}

}  // namespace flatray
