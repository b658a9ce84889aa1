#pragma once
#include <gtest/gtest.h>

#include "render/frame.h"
#include "scene/load.h"
#include "support/paths.h"

namespace flatray {

/// A scene from its text, or a test failure that shows what is wrong with it.
inline Scene scene_of(const std::string& text, const std::vector<Override>& overrides = {}) {
  Result<LoadedScene> loaded = load_scene_text("test.toml", text, overrides);
  if (!loaded) {
    ADD_FAILURE() << format(loaded.error());
    return {};
  }
  return std::move(loaded->scene);
}

/// A scene of the project, by its path below the project's folder.
inline Scene scene_at(const std::string& path, const std::vector<Override>& overrides = {}) {
  Result<LoadedScene> loaded =
      load_scene(source_path("/" + path), overrides, {.root = source_path()});
  if (!loaded) {
    ADD_FAILURE() << format(loaded.error());
    return {};
  }
  return std::move(loaded->scene);
}

inline Image picture(const Scene& scene, unsigned frame = 1, const FrameOptions& options = {}) {
  const Timeline timeline(scene, scene.seed, std::max(frame, scene.frames));
  return render_image(*draw_list(make_plan(scene, false), timeline, frame), options);
}

inline Image picture(const std::string& text, unsigned frame = 1,
                     const FrameOptions& options = {}) {
  return picture(scene_of(text), frame, options);
}

/// Colours the picture holds apart from its first pixel's: a guard against comparing two blanks.
inline bool has_content(const Image& image) {
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    if (image.pixels[i] != image.pixels[i % static_cast<std::size_t>(image.channels)]) return true;
  return false;
}

}  // namespace flatray
