#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/files/outputs.h"
#include "image/compare.h"
#include "scene/scene.h"

namespace flatray {

/// What a golden picture may be: small enough to look at and to keep for ever.
inline constexpr int kGoldenWidth = 320, kGoldenHeight = 200;
inline constexpr std::size_t kGoldenFrames = 3;            ///< of one scene
inline constexpr std::uintmax_t kGoldenBytes = 2'000'000;  ///< of all PNG files together

/// What a picture may differ by from its golden: in any channel, and in how many pixels.
struct Tolerance {
  int levels = 0;
  std::uint64_t pixels = 0;

  bool allows(const Difference& difference) const {
    return difference.worst <= levels && difference.pixels <= pixels;
  }
  /// "max=0;pixels=0".
  std::string text() const;
  /// nullopt for any other text.
  static std::optional<Tolerance> parse(std::string_view text);
};

/// A committed picture: a line of golden_images/manifest.json. The software back end must meet it
/// exactly, a GL back end within the tolerance measured when it was accepted.
struct GoldenRow {
  std::string scene;  ///< path below the project's root: "scenes/chamber/hall.toml"
  unsigned frame = 1;
  std::uint64_t seed = 0;
  int width = 0, height = 0;
  std::string pixels;      ///< pixel_hash of the picture
  std::string scene_hash;  ///< Scene::hash when it was accepted
  std::string drift;       ///< measured between renders when it was accepted: "max=0;pixels=0"
  std::string why;         ///< it was accepted
  std::string backend = "software";  ///< or "gl"
  Tolerance tolerance = {};          ///< nothing for the software back end
  std::string renderer = {};         ///< of a GL picture: what drew it, with the version of Mesa

  bool exact() const { return backend == "software"; }
  bool is_of(const std::string& path, const std::string& by) const {
    return scene == path && backend == by;
  }

  /// "chamber/hall": how people name the scene.
  std::string name() const;
  /// "chamber_hall": its folder below golden_images.
  std::string folder() const;
  /// "golden_images/chamber_hall/frame_0003.png"; "gl_frame_0003.png" for a GL picture.
  std::string file() const;
  /// "out/golden/chamber_hall/frame_0003": where pictures to look at are left.
  std::string look() const;
};

/// Rows of `root`/golden_images/manifest.json, sorted by file.
/// Error   Trouble::missing without a manifest; Trouble::invalid for what is not one, all bad rows
///         together: paths that leave the project, rows without a value, two rows of one file, a
///         file that is not the row's own.
Result<std::vector<GoldenRow>> read_goldens(const std::filesystem::path& root);

/// Replaces the manifest, atomically; a line for each row.
Result<void> write_goldens(const std::filesystem::path& root, std::vector<GoldenRow> rows,
                           const Outputs& outputs = {});

/// The scene file a user means by "chamber/hall", "chamber/hall.toml" or
/// "scenes/chamber/hall.toml": its path below `root`. Error   Trouble::missing with the nearest
/// name; Trouble::usage where two files have that name.
Result<std::string> find_scene(const std::filesystem::path& root, const std::string& name);

/// Scene::hash as rows hold it.
std::string scene_hash(const Scene& scene);

/// A scene of `row`, drawn at the row's size; its world follows where it is of pixels. The hash stays.
Result<Scene> scene_of_size(Scene scene, const std::filesystem::path& root, const GoldenRow& row);

/// A row's scene as the row draws it.
struct GoldenScene {
  Scene scene;          ///< at the row's size
  std::string options;  ///< of `flatray render` that draw it alike: " --size 320x180", "" where
                        /// < none are needed
};
Result<GoldenScene> load_golden_scene(const std::filesystem::path& root, const GoldenRow& row);
/// A golden of light is drawn with 2^15 rays at most. Gives   whether the scene asks for more.
bool limit_golden_light(Scene& scene);

/// The picture a row asks for, by its back end or another way: "osmesa", "egl". Same bytes for any
/// number of threads.
/// Error   Trouble::unavailable where its back end is not here.
struct GoldenPicture {
  Image image;
  std::string renderer;  ///< as the row's
};
Result<GoldenPicture> render_golden(const Scene& scene, const GoldenRow& row,
                                    const std::string& backend, unsigned threads);

/// PNG files below golden_images without a row: paths below `root`, sorted.
Result<std::vector<std::string>> stray_goldens(const std::filesystem::path& root,
                                               const std::vector<GoldenRow>& rows);

}  // namespace flatray
