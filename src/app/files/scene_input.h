#pragma once
#include "anim/frame_state.h"
#include "app/options/option_table.h"
#include "base/parallel.h"
#include "scene/load.h"

namespace flatray {

// Rows that several verbs have, so that they mean the same everywhere.
inline constexpr SharedRow kForceRow = {"--force",
                                        "also replace inputs, and what no such command wrote"};
inline constexpr SharedRow kJsonRow = {"--json", "print one JSON object"};
inline constexpr SharedRow kCsvRow = {"--csv", "print comma-separated values"};
inline constexpr SharedRow kQuietRow = {"-q, --quiet", "print no warnings and no summary"};
inline constexpr std::uint64_t kMostSeed = ~std::uint64_t{0} >> 1;  ///< what a TOML integer holds

/// -j: all threads of the machine without it.
void row_of_threads(OptionTable& row, unsigned& threads);
/// -f of verbs that show one frame.
void row_of_frame(OptionTable& row, unsigned& frame);

/// The options of verbs that read scenes.
struct SceneOptions {
  std::vector<Override> overrides;
  LoadLimits limits{.threads = hardware_threads()};
  std::optional<std::uint64_t> seed;  ///< instead of the scene's

  void rows(OptionTable& row);
  /// --seed, of what the scene draws; or of all that the verb draws besides.
  void row_of_seed(OptionTable& row);
  void row_of_seed(OptionTable& row, std::uint64_t& all_draws, std::uint64_t most = kMostSeed);
  std::uint64_t seed_of(const Scene& scene) const { return seed.value_or(scene.seed); }
};

/// Loads a scene with the -D of the command line, then `more`. Its warnings are not printed yet.
Result<LoadedScene> load_input(const SceneOptions& options, const std::string& path,
                               const std::vector<Override>& more = {});

/// The same with the scene's description.
Result<ReadScene> read_input(const SceneOptions& options, const std::string& path,
                             const std::vector<Override>& more = {});

/// The same for verbs of one scene: the first operand, its warnings printed.
Result<Scene> load_only_input(const Arguments& arguments, const SceneOptions& options);

/// Refuses a scene with a magnetic field for what follows straight rays, as "hit".
Result<void> expect_no_field(const Scene& scene, const std::string& what);

/// Refuses a scene with glass for what knows mirrors only.
Result<void> expect_no_glass(const Scene& scene, const std::string& what);

/// Refuses a scene with rays of finite speed for what knows walls that stand still only.
Result<void> expect_no_speed(const Scene& scene, const std::string& what);

/// State of the scene at a frame with --seed.
Result<FrameState> frame_of(const SceneOptions& options, const Scene& scene, unsigned frame);

}  // namespace flatray
