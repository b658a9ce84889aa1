#include "app/help/build_parts.h"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>

namespace flatray {
namespace {

// How many things of a scene a part is about, and in which words.
struct Use {
  std::size_t count;
  const char* words;

  Use(std::size_t number, const char* one, const char* several = nullptr)
      : count(number), words(number == 1 || several == nullptr ? one : several) {}
};

// A row for each part that a scene may call for without naming it.
struct Part {
  const char* name;
  Use (*use)(const Scene& scene);
};

Use rays(const Scene& scene, const char* one, const char* several) {
  return {scene.rays.size(), one, several};
}

const Part kParts[] = {
    {"MPFR",
     [](const Scene& scene) {
       return rays(scene, "ray whose orbit it would certify", "rays whose orbits it would certify");
     }},
    {"EMBREE",
     [](const Scene& scene) {
       return rays(scene, "ray on which it would be a second opinion",
                   "rays on which it would be a second opinion");
     }},
    {"passes/bounding_boxes",
     [](const Scene& scene) {
       const auto boxes = std::ranges::count_if(
           scene.entities, [](const Entity& one) { return !!one.bounding_box; });
       return Use{static_cast<std::size_t>(boxes), "box to be drawn", "boxes to be drawn"};
     }},
    {"passes/chambers",
     [](const Scene& scene) {
       return Use{scene.chambers.size(), "chamber to be drawn", "chambers to be drawn"};
     }},
    {"passes/contacts",
     [](const Scene& scene) {
       const auto& asked = scene.collisions;
       const bool drawn =
           asked && (asked->points || asked->normals || asked->ghosts || asked->time_bar);
       return Use{drawn ? std::size_t{1} : 0, "[collisions] to be drawn"};
     }},
    {"passes/edge_rays",
     [](const Scene& scene) {
       return Use{scene.edge_rays.size(), "pair of entities", "pairs of entities"};
     }},
    {"passes/entities",
     [](const Scene& scene) {
       return Use{scene.entities.size(), "entity to be drawn", "entities to be drawn"};
     }},
    {"passes/orbits",
     [](const Scene& scene) { return rays(scene, "ray to be drawn", "rays to be drawn"); }}};

MissingPart missing_part(const Scene& scene, std::string_view name) {
  for (const Part& part : kParts) {
    if (name != part.name) continue;
    const Use use = part.use(scene);
    return {std::string(name), use.count > 0, fmt::format("{} {}", use.count, use.words)};
  }
  if (name == "GL") return {std::string(name), false, "software draws, unless --backend says else"};
  if (name.starts_with("shapes/") || name.starts_with("formats/"))
    return {std::string(name), false, "a scene that needs it is refused"};
  return {std::string(name), false, "nothing of a scene calls for it"};
}

}  // namespace

std::vector<MissingPart> missing_parts(const Scene& scene,
                                       std::span<const std::string_view> left_out) {
  std::vector<MissingPart> parts;
  for (const std::string_view name : left_out) parts.push_back(missing_part(scene, name));
  return parts;
}

Result<void> can_draw(const Scene& scene, std::span<const std::string_view> left_out) {
  Diagnostics problems;
  for (const std::string_view name : left_out) {
    if (!name.starts_with("passes/")) continue;
    if (const MissingPart part = missing_part(scene, name); part.concerns)
      problems.push_back(
          {named_place(scene.name),
           fmt::format("has {}, and {} is left out of this build", part.reason, name),
           "configure it without FLATRAY_ONLY and FLATRAY_WITHOUT", Trouble::unavailable});
  }
  if (problems.empty()) return {};
  return tl::unexpected(std::move(problems));
}

}  // namespace flatray
