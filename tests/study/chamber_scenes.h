#pragma once
#include <stdexcept>

#include "base/check.h"
#include "scene/load.h"
#include "study/experiment.h"

namespace flatray::testing {

inline Scene scene_of(const std::string& text) {
  auto loaded = load_scene_text("room.toml", "flatray = 1\n" + text);
  FLATRAY_CHECK(loaded.has_value(), loaded ? "" : format(loaded.error()));
  return std::move(loaded->scene);
}

inline Scene room(const std::string& shape, const std::string& pillars = "") {
  return scene_of("film = { size = [32, 24] }\n[[chamber]]\nshape = { " + shape +
                  " }\npillars = [" + pillars + "]\n");
}

inline Scene sinai(const std::string& radius) {
  return room("box = { min = [0, 0], max = [1, 1] }",
              "{ shape = { circle = { centre = [0.5, 0.5], radius = " + radius + " } } }");
}

inline Scene stadium(const std::string& half_length = "1") {
  return room("capsule = { from = [-" + half_length + ", 0], to = [" + half_length +
              ", 0], radius = 1 }");
}

/// A chamber with holes in its walls.
inline Scene with_holes(const std::string& shape, const std::string& holes) {
  return scene_of("film = { size = [24, 20] }\n[[chamber]]\nname = \"room\"\nshape = { " + shape +
                  " }\nholes = [" + holes + "]\n");
}

/// Sinai's torus: a disc in a box of which opposite sides are one.
inline Scene torus(const std::string& radius) {
  return scene_of(
      "film = { size = [32, 24] }\n[[chamber]]\nshape = { box = { min = [0, 0], max = [1, 1] } }\n"
      "material = \"periodic\"\npillars = [{ shape = { circle = { centre = [0.5, 0.5], radius = " +
      radius + " } } }]\n");
}

inline const Experiment& experiment(const std::string& name) {
  for (const Experiment* one : experiments())
    if (name == one->name) return *one;
  throw std::logic_error(name + " is not registered");
}

inline ExperimentResult run(const std::string& name, const ExperimentContext& context) {
  auto result = experiment(name).run(context);
  FLATRAY_CHECK(result.has_value(), result ? "" : format(result.error()));
  return std::move(*result);
}

inline Measure measure(const ExperimentResult& result, const std::string& name) {
  for (const Measure& one : result.measures)
    if (one.name == name) return one;
  throw std::logic_error("no measure " + name);
}

}  // namespace flatray::testing
