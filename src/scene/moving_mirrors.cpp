#include "scene/moving_mirrors.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "scene/material.h"
#include "scene/part_counts.h"
#include "scene/responses.h"

namespace flatray {
namespace {

bool has_ease(const Scene& scene, const Motion& motion, Curve::Ease ease) {
  return std::ranges::any_of(std::array{motion.x, motion.y}, [&](const auto& curve) {
    return curve && scene.curves[*curve].ease == ease;
  });
}

// "" where it moves straight from key to key.
const char* why_not_straight(const Scene& scene, const Movable& thing) {
  if (thing.angular_velocity != 0 || thing.motion.angle) return "turns";
  if (thing.motion.follow) return "follows a path";
  if (has_ease(scene, thing.motion, Curve::Ease::smooth)) return "follows a smooth curve";
  if (has_ease(scene, thing.motion, Curve::Ease::step)) return "jumps from key to key";
  return "";
}

bool has_arcs(const Scene& scene, ShapeId shape) {
  return shape < scene.shapes.size() && part_counts(scene.shapes[shape]).other_curves() > 0;
}

std::string why_not(const Scene& scene, const Entity& entity) {
  if (std::string why = why_not_straight(scene, entity); !why.empty()) return why;
  if (entity.markov && changes_outline_or_velocity(*entity.markov))
    return "changes its shape or velocity by its states";
  if (has_arcs(scene, entity.shape)) return "has curves other than circles";
  if (entity.shape < scene.shapes.size() && scene.shapes[entity.shape].changes != kNoEntry)
    return "changes its size";
  for (auto at = entity.group; at; at = scene.groups[*at].group) {
    const Group& group = scene.groups[*at];
    if (const std::string why = why_not_straight(scene, group); !why.empty())
      return fmt::format("is in a group that {}", why);
    if (group.scale.curve) return "is in a group that changes its size";
  }
  return {};
}

void refuse(Diagnostics& problems, const Place& where, const std::string& what) {
  problems.push_back({where, what + ": no ray of finite speed can be followed there",
                      "leave the ray's speed out, so that mirrors are met as each frame has them; "
                      "else mirrors are polygons and circles in straight motion",
                      Trouble::invalid});
}

}  // namespace

Diagnostics refused_mirrors(const Scene& scene) {
  Diagnostics problems;
  if (const Place* glass = place_of_glass(scene)) refuse(problems, *glass, "glass splits rays");
  for (const Entity& entity : scene.entities) {
    if (!entity.material) continue;
    if (const std::string why = why_not(scene, entity); !why.empty())
      refuse(problems, entity.where, called("mirror", entity.name, entity.where) + " " + why);
  }
  for (const Chamber& chamber : scene.chambers) {
    if (chamber.material == Material::periodic)
      refuse(problems, chamber.where,
             called("chamber", chamber.name, chamber.where) + " has periodic walls");
    bool arcs = has_arcs(scene, chamber.shape);
    for (const Chamber::Pillar& pillar : chamber.pillars) arcs |= has_arcs(scene, pillar.shape);
    if (arcs)
      refuse(problems, chamber.where,
             called("chamber", chamber.name, chamber.where) + " has curves other than circles");
  }
  return problems;
}

}  // namespace flatray
