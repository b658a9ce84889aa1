#pragma once
#include <span>
#include <string>

#include "app/files/scene_input.h"
#include "app/options/light_wish.h"
#include "study/accuracy/accuracy.h"

namespace flatray {

/// What `accuracy --profile` writes, for `render --error` and `--time` to choose from: a line of
/// JSON about the scene, then one for each measured way to draw it.
std::string profile_text(const Scene& scene, std::span<const ChoiceReport> reports);

/// --profile, --error and --time.
struct ProfileOptions {
  std::string file;                      ///< "": none
  std::optional<double> error, seconds;  ///< asked of it

  /// Where it is none, `light` takes --error and --time.
  void rows(OptionTable& row, LightWish& light);
};

/// Adds --backend, --samples and -D to the arguments as the profile says, if there is one. Says on
/// standard error what it has chosen, unless --quiet.
///
/// Error   Trouble::invalid, with the line of the profile, where that is none, is of another scene,
///         or has nothing so good.
Result<void> choose_by_profile(Arguments& arguments, const ProfileOptions& options,
                               const SceneOptions& scene);

}  // namespace flatray
