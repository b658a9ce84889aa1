#pragma once
#include <gtest/gtest.h>

#include <stdexcept>

#include "base/check.h"
#include "base/entry_named.h"
#include "scene/load.h"
#include "study/experiment.h"
#include "study/texts.h"

namespace flatray::testing {

inline Scene scene_of(const std::string& text) {
  auto loaded = load_scene_text("room.toml", "flatray = 1\n" + text);
  FLATRAY_CHECK(loaded.has_value(), loaded ? "" : format(loaded.error()));
  return std::move(loaded->scene);
}

/// A chamber with more of its keys.
inline Scene chamber_with(const std::string& shape, const std::string& more,
                          const std::string& film = "size = [32, 24]") {
  return scene_of("film = { " + film + " }\n[[chamber]]\nshape = { " + shape + " }\n" + more);
}

inline Scene room(const std::string& shape, const std::string& pillars = "") {
  return chamber_with(shape, "pillars = [" + pillars + "]\n");
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
  return chamber_with(shape, "name = \"room\"\nholes = [" + holes + "]\n", "size = [24, 20]");
}

/// Sinai's torus: a disc in a box of which opposite sides are one.
inline Scene torus(const std::string& radius) {
  return chamber_with(
      "box = { min = [0, 0], max = [1, 1] }",
      "material = \"periodic\"\npillars = [{ shape = { circle = { centre = [0.5, 0.5], radius = " +
          radius + " } } }]\n");
}

/// A mirror in the open.
inline std::string mirror_disc(const std::string& centre, const std::string& radius = "1") {
  return "[[entity]]\nname = \"disc\"\nmaterial = \"mirror\"\nshape = { circle = { centre = [" +
         centre + "], radius = " + radius + " } }\n";
}

/// Three discs of radius 1 with centres 6 apart.
inline std::string three_discs_6_apart() {
  return mirror_disc("3.4641016151377544, 0") + mirror_disc("-1.7320508075688772, 3") +
         mirror_disc("-1.7320508075688772, -3");
}

inline const Experiment& experiment(const std::string& name) {
  const Experiment* found = entry_named(experiments(), name);
  FLATRAY_CHECK(found != nullptr, name + " is not registered");
  return *found;
}

inline bool is_unavailable(const Result<ExperimentResult>& result) {
  return !result && result.error().front().trouble == Trouble::unavailable;
}

inline ExperimentResult run(const std::string& name, const ExperimentContext& context) {
  auto result = experiment(name).run(context);
  FLATRAY_CHECK(result.has_value(), result ? "" : format(result.error()));
  return std::move(*result);
}

inline const std::string& content_of(const ExperimentResult& result, const std::string& file) {
  for (const ExperimentResult::File& one : result.files)
    if (one.name == file) return one.content;
  throw std::logic_error("no file " + file);
}

inline void expect_same_files(const ExperimentResult& a, const ExperimentResult& b) {
  ASSERT_EQ(a.files.size(), b.files.size());
  for (std::size_t i = 0; i < a.files.size(); ++i) {
    EXPECT_EQ(a.files[i].name, b.files[i].name);
    EXPECT_EQ(a.files[i].content, b.files[i].content) << a.files[i].name;
  }
}

inline Measure measure(const ExperimentResult& result, const std::string& name) {
  for (const Measure& one : result.measures)
    if (one.name == name) return one;
  throw std::logic_error("no measure " + name);
}

}  // namespace flatray::testing
