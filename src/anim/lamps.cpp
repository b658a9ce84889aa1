#include "anim/lamps.h"

#include <algorithm>

#include "anim/motion.h"
#include "base/light.h"
#include "scene/curve.h"
#include "scene/lamp.h"

namespace flatray {
namespace {

Pose lamp_pose(const Scene& scene, std::uint32_t index, const FrameState& state,
               std::span<const GroupPose> groups) {
  const Lamp& lamp = scene.lamps[index];
  const Placed now = placed(scene, lamp, state.time);
  const Vec2 moved = lamp.markov ? state.lamps[index].moved : Vec2(lamp.velocity * state.time);
  const auto [at, angle, scale] = in_world(
      held(now.at + moved), now.angle + lamp.angular_velocity * state.time, lamp.group, groups);
  return pose(at + state.displaced, angle, scale);
}

LightColour paint_light(const Scene& scene, const Paint& paint, double time) {
  if (paint.curve == kNoEntry)
    return {static_cast<double>(linear_from_srgb(paint.r)),
            static_cast<double>(linear_from_srgb(paint.g)),
            static_cast<double>(linear_from_srgb(paint.b))};
  const auto channel = [&](CurveId i) { return value_at(scene.curves[paint.curve + i], time); };
  return {channel(0), channel(1), channel(2)};
}

LightColour lamp_colour(const Scene& scene, const LampLight& light, double time) {
  if (light.wavelength) return colour_of_wavelength(plus(scene, *light.wavelength, time));
  if (light.temperature) return colour_of_temperature(plus(scene, *light.temperature, time));
  if (light.spectrum) return light.spectrum->colour();
  return paint_light(scene, light.colour, time);
}

const LampLight& light_in(const Lamp& lamp, const FrameState& state, std::uint32_t index) {
  if (!lamp.markov) return lamp;
  const std::vector<Look>& looks = lamp.markov->looks[state.lamps[index].state];
  return looks.empty() ? lamp : *looks[state.lamps[index].sub_state].light;
}

}  // namespace

std::vector<LampState> lamp_states(const Scene& scene, const FrameState& state) {
  std::vector<LampState> states;
  if (scene.lamps.empty()) return states;
  const std::vector<GroupPose> groups = group_poses(scene, state.time);
  for (std::uint32_t i = 0; i < scene.lamps.size(); ++i) {
    const Lamp& lamp = scene.lamps[i];
    const LampLight& light = light_in(lamp, state, i);
    LightColour colour = lamp_colour(scene, light, state.time);
    const double most = *std::ranges::max_element(colour);
    const double power = plus(scene, light.power, state.time) * most;
    auto emitter = emitter_at(scene, lamp, state.time);
    if (!(power > 0) || emitter == nullptr) continue;
    for (double& channel : colour) channel /= most;
    states.push_back({i, lamp_pose(scene, i, state, groups), power, colour,
                      light.wavelength ? plus(scene, *light.wavelength, state.time) : 0.0,
                      light.spectrum.get(), std::move(emitter), lamp.type->numbers});
  }
  return states;
}

bool moves(const Lamp& lamp) {
  const auto curved = [](const std::optional<Moving>& number) { return number && number->curve; };
  return lamp.markov || lamp.changes_place() || lamp.power.curve || lamp.colour.curve != kNoEntry ||
         curved(lamp.wavelength) || curved(lamp.temperature) ||
         std::ranges::any_of(lamp.source.arguments, [&](const KeptArguments::Argument& argument) {
           return std::ranges::any_of(
               argument.numbers, [](const Moving& number) { return number.curve.has_value(); });
         });
}

}  // namespace flatray
