#include "app/help/build_parts.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/counted.h"

namespace flatray {
namespace {

std::size_t rays(const Scene& scene) { return scene.rays.size(); }
std::size_t chambers(const Scene& scene) { return scene.chambers.size(); }
std::size_t edge_rays(const Scene& scene) { return scene.edge_rays.size(); }
std::size_t entities(const Scene& scene) { return scene.entities.size(); }

std::size_t boxes(const Scene& scene) {
  return static_cast<std::size_t>(
      std::ranges::count_if(scene.entities, [](const Entity& one) { return !!one.bounding_box; }));
}

std::size_t contacts(const Scene& scene) {
  const auto& asked = scene.collisions;
  return asked && (asked->points || asked->normals || asked->ghosts || asked->time_bar) ? 1 : 0;
}

// A row for each part that a scene may call for without naming it: how many things of a scene it is
// about, and in which words.
struct Part {
  const char* name;
  std::size_t (*count)(const Scene& scene);
  const char *one, *several;
};
constexpr Part kParts[] = {
    {"MPFR", &rays, "ray whose orbit it would certify", "rays whose orbits it would certify"},
    {"EMBREE", &rays, "ray on which it would be a second opinion",
     "rays on which it would be a second opinion"},
    {"passes/bounding_boxes", &boxes, "box to be drawn", "boxes to be drawn"},
    {"passes/chambers", &chambers, "chamber to be drawn", "chambers to be drawn"},
    {"passes/contacts", &contacts, "[collisions] to be drawn", "[collisions] to be drawn"},
    {"passes/edge_rays", &edge_rays, "pair of entities", "pairs of entities"},
    {"passes/entities", &entities, "entity to be drawn", "entities to be drawn"},
    {"passes/orbits", &rays, "ray to be drawn", "rays to be drawn"}};

MissingPart missing_part(const Scene& scene, std::string_view name) {
  for (const Part& part : kParts) {
    if (name != part.name) continue;
    const std::size_t count = part.count(scene);
    return {std::string(name), count > 0, counted(count, part.one, part.several)};
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
          {scene.where, fmt::format("has {}, and {} is left out of this build", part.reason, name),
           "configure it without FLATRAY_ONLY and FLATRAY_WITHOUT", Trouble::unavailable});
  }
  if (problems.empty()) return {};
  return tl::unexpected(std::move(problems));
}

}  // namespace flatray
