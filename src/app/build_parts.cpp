#include "app/build_parts.h"

#include <fmt/core.h>

#include <algorithm>

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
       const auto boxes = std::count_if(scene.entities.begin(), scene.entities.end(),
                                        [](const Entity& one) { return !!one.bounding_box; });
       return Use{static_cast<std::size_t>(boxes), "box to be drawn", "boxes to be drawn"};
     }},
    {"passes/chambers",
     [](const Scene& scene) {
       return Use{scene.chambers.size(), "chamber to be drawn", "chambers to be drawn"};
     }},
    {"passes/contacts",
     [](const Scene& scene) {
       return Use{scene.collisions ? std::size_t{1} : 0, "[collisions] that may be drawn"};
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

MissingPart missing_part(const Scene& scene, const std::string& name) {
  for (const Part& part : kParts) {
    if (name != part.name) continue;
    const Use use = part.use(scene);
    return {name, use.count > 0, fmt::format("{} {}", use.count, use.words)};
  }
  if (name == "GL") return {name, false, "software draws, unless --backend says else"};
  if (name.starts_with("shapes/") || name.starts_with("formats/"))
    return {name, false, "a scene that needs it is refused"};
  return {name, false, "nothing of a scene calls for it"};
}

}  // namespace

std::vector<std::string> left_out_of_build() {
  // The build passes it (CMakeLists.txt of this folder), names with a blank after each.
  std::vector<std::string> names;
  std::string_view rest = FLATRAY_LEFT_OUT;
  for (std::size_t end = 0; (end = rest.find(' ')) != std::string_view::npos;
       rest.remove_prefix(end + 1))
    names.emplace_back(rest.substr(0, end));
  return names;
}

std::vector<MissingPart> missing_parts(const Scene& scene, std::span<const std::string> left_out) {
  std::vector<MissingPart> parts;
  for (const std::string& name : left_out) parts.push_back(missing_part(scene, name));
  return parts;
}

}  // namespace flatray
