#pragma once
#include <gtest/gtest.h>

#include <span>
#include <string>

#include "base/check.h"
#include "scene/load.h"

namespace flatray {

inline Result<LoadedScene> load(std::string text, const std::vector<Override>& overrides = {}) {
  return load_scene_text("t.toml", std::move(text), overrides);
}

/// The scene, or the end of the program with what is wrong.
inline LoadedScene loaded(std::string text, const std::vector<Override>& overrides = {}) {
  Result<LoadedScene> result = load(std::move(text), overrides);
  FLATRAY_CHECK(result.has_value(), result ? "" : format(result.error()));
  return std::move(*result);
}

/// What the user reads of a scene that is refused; "" for one that is not.
inline std::string refusal(std::string text, const std::vector<Override>& overrides = {}) {
  const Result<LoadedScene> result = load(std::move(text), overrides);
  return result ? "" : format(result.error());
}

/// A scene of one entity of a shape.
inline std::string with_shape(const std::string& shape) {
  return "flatray = 1\n[[entity]]\nname = \"e\"\nshape = { " + shape + " }\n";
}

/// The shape of that scene.
inline Shape shape_of(const std::string& shape) {
  return loaded(with_shape(shape)).scene.shapes.at(0);
}

/// A text and a part of what the user reads when it is refused.
struct Refused {
  std::string text, message;
};

/// A scene is refused, among others with that message.
inline void expect_problem(const std::string& text, const std::string& message) {
  EXPECT_NE(refusal(text).find(message), std::string::npos) << refusal(text);
}

/// A scene of one lamp.
inline std::string with_lamp(const std::string& keys) {
  return "flatray = 1\n[[lamp]]\n" + keys + "\n";
}

/// Every text is refused so; `show` gives what the user reads of one.
template <class Show>
void expect_refused(std::span<const Refused> cases, const Show& show) {
  for (const auto& [text, message] : cases) {
    const std::string shown = show(text);
    EXPECT_NE(shown.find(message), std::string::npos) << text << "\n" << shown;
  }
}

}  // namespace flatray
