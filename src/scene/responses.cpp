#include "scene/responses.h"

#include <algorithm>

#include "scene/outlines/rounded.h"

namespace flatray {

Response response_of(const Scene& scene, const Entity& entity) {
  return entity.response.value_or(scene.collisions ? scene.collisions->response : Response::none);
}

bool responds(const Scene& scene) {
  return std::ranges::any_of(scene.entities, [&](const Entity& entity) {
    return response_of(scene, entity) != Response::none;
  });
}

Place where_responds(const Scene& scene) {
  return scene.collisions ? scene.collisions->where
                          : std::ranges::find_if(scene.entities, [](const Entity& e) {
                              return e.response.has_value();
                            })->where;
}

Diagnostic refused_responses(const Scene& scene, const std::string& what) {
  return {where_responds(scene),
          "entities respond to contact, and " + what + " looks at what goes on undisturbed",
          "write response = \"none\", here and in the entities, to see them undisturbed",
          Trouble::invalid};
}

std::optional<Hindrance> hindrance(const Scene& scene, const Entity& entity) {
  if (entity.angular_velocity != 0) return Hindrance{"angular_velocity", "turns"};
  if (entity.motion.angle) return Hindrance{"angle", "turns"};
  if (entity.motion.x || entity.motion.y) return Hindrance{"at", "follows a curve"};
  if (entity.motion.follow) return Hindrance{"follow", "follows a path"};
  if (!stands_still(scene, entity.group)) return Hindrance{"group", "is in a group that moves"};
  if (entity.markov && changes_outline_or_velocity(*entity.markov))
    return Hindrance{"states", "changes its shape or velocity by its states"};
  if (scene.shapes[entity.shape].changes != kNoEntry) return Hindrance{"shape", "changes its size"};
  if (has_parts_left_out(scene.shapes[entity.shape]))
    return Hindrance{
        "shape",
        "has curves other than circles and capsules, or crossing outlines, which nothing can meet"};
  return std::nullopt;
}

bool changes_outline_or_velocity(const MarkovUse& markov) {
  for (const std::vector<Look>& state : markov.looks)
    for (const Look& look : state)
      if (look.shape || look.velocity) return true;
  return false;
}

bool has_parts_left_out(const Shape& shape, bool but_ellipses) {
  return !shape.crossing_rings.empty() || !shape.beziers.empty() ||
         std::ranges::any_of(shape.arc_paths, [&](const ArcPath& path) {
           return !rounded_by(path) && !(but_ellipses && path.is_ellipse());
         });
}

bool moves(const Group& group) { return group.changes_place() || group.scale.curve; }

bool stands_still(const Scene& scene, std::optional<std::uint32_t> group) {
  for (; group; group = scene.groups[*group].group)
    if (moves(scene.groups[*group])) return false;
  return true;
}

}  // namespace flatray
