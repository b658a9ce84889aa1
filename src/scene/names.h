#pragma once
#include <string>

#include "scene/scene.h"

namespace flatray {

/// What tables and answers call a thing: its name, or where it has none its kind and number, counted from 1.
/// Messages with a place say the line instead: called() (base/diagnostic.h).
inline std::string name_or_number(const std::string& name, const char* kind, std::size_t index) {
  return name.empty() ? kind + (' ' + std::to_string(index + 1)) : name;
}
inline std::string entity_name(const Scene& scene, std::size_t entity) {
  return name_or_number(scene.entities[entity].name, "entity", entity);
}
inline std::string chamber_name(const Scene& scene, std::size_t chamber) {
  return name_or_number(scene.chambers[chamber].name, "chamber", chamber);
}
inline std::string ray_name(const Scene& scene, std::size_t ray) {
  return name_or_number(scene.rays[ray].name, "ray", ray);
}

}  // namespace flatray
