#pragma once
#include <optional>

#include "app/files/output_pattern.h"
#include "app/frames/frames.h"
#include "app/options/option_table.h"
#include "render/light/light_run.h"

namespace flatray {

struct RenderJob;

inline constexpr SharedRow kErrorImageRow = {
    "--error-image PATTERN", "where the error of light goes: half of 95 % intervals",
    &endings_of_pictures};

/// What the command line says of light.
struct LightWish {
  std::optional<std::uint64_t> rays;
  std::optional<LightEstimator> estimator;
  double seconds = kInfinity;  ///< of a frame
  double error = 0;            ///< relative standard error that is enough
  Shard shard;                 ///< of the rounds of rays
  bool resume = false;         ///< more rays for the film that is there
  std::optional<OutputPattern> error_image;

  bool any() const {
    return rays || estimator || seconds < kInfinity || error > 0 || shard.count > 1 || error_image;
  }
  LightGoal goal() const { return {shard.index, shard.count, seconds, error, {}}; }

  /// --rays and what follows it.
  void rows(OptionTable& row);
  /// --error and --time, rows told before.
  void read_ends(OptionTable& row);
};

/// Gives a job its wish, and its scene the rays and scrambles for it. A film has whole rounds, so
/// that more can be added.
/// Error   Trouble::usage: what does not go with the scene or the other options.
Result<void> wish_light(const Arguments& arguments, const LightWish& wish, RenderJob& job);

}  // namespace flatray
