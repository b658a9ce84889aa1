#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "scene/reading/scene_desc.h"
#include "scene/scene.h"

namespace flatray {

/// `-D key=value`: `key` a dotted path ("film.size", "entity.2.at", "markov.runner.hold"), `value`
/// as TOML.
struct Override {
  std::string key, value;
  Place where{};  ///< where it is said, if not by -D: messages name that
};

struct LoadLimits {
  std::uint64_t max_pixels = std::uint64_t{1} << 28;
  std::size_t max_bytes = std::size_t{1} << 30;  ///< of the scene and all files it refers to
  std::size_t max_depth = 64;                    ///< groups in groups, files in files
  std::size_t max_entities = 1'000'000;  ///< also pillars, rays, groups: of each, with all copies
  std::uint64_t max_corners = std::uint64_t{1} << 25;  ///< kept with all copies; drawn in one frame
  std::filesystem::path root =
      {};                ///< of the files it refers to; "": import_root of scene/imports/imports.h
  unsigned threads = 1;  ///< to read large outlines with; what they hold does not depend on it
};

struct LoadedScene {
  Scene scene;
  Diagnostics warnings;
};

/// Reads, parses (format by extension, or by content for "-") and builds a scene.
/// `seed` replaces the scene's, of which all is drawn that is random in a scene.
/// Error   the one syntax error, or every semantic mistake together, each with its place.
Result<LoadedScene> load_scene(const std::filesystem::path& path,
                               const std::vector<Override>& overrides = {},
                               const LoadLimits& limits = {},
                               std::optional<std::uint64_t> seed = {});

/// The same from text already read, e.g. in tests: `name` decides the format by its extension.
Result<LoadedScene> load_scene_text(std::string name, std::string text,
                                    const std::vector<Override>& overrides = {},
                                    const LoadLimits& limits = {},
                                    std::optional<std::uint64_t> seed = {});

/// A scene that was read as it is described: what formats and -D make of it, before its meaning.
struct ReadScene {
  SceneDesc desc;
  LoadedScene loaded;
};
/// The same scene and its description, for writing it in another way.
Result<ReadScene> read_scene(const std::filesystem::path& path,
                             const std::vector<Override>& overrides = {},
                             const LoadLimits& limits = {}, std::optional<std::uint64_t> seed = {});

}  // namespace flatray
