#pragma once
#include <optional>
#include <vector>

#include "app/files/scene_input.h"
#include "app/frames/render_job.h"
#include "app/options/option_values.h"

namespace flatray {

/// What all scenes of one `flatray render` share. Verbs bind what they have of it.
struct RenderRequest {
  SceneOptions scene;
  std::optional<FilmSize> size;
  std::optional<std::vector<unsigned>> frames;
  std::optional<std::string> crop;
  std::optional<OutputPattern> output;
  const PictureFormat* format = nullptr;  ///< where `output` does not say it; null: PNG
  Shard shard;
  bool resume = false, keep_all = false;

  unsigned threads() const { return scene.limits.threads; }
  void row_of_size(OptionTable& row);  ///< `read_size` once the limit is read
  void read_size(OptionTable& row);
  void row_of_format(OptionTable& row);  ///< once --output is told; reads that, too
};

/// A job for each scene. All are read before the first picture: one mistake, and nothing is
/// rendered. Error   all mistakes of all scenes; Trouble::usage where pattern, frames and scenes do
/// not fit together.
Result<std::vector<RenderJob>> make_jobs(const Arguments& arguments, const RenderRequest& request);

}  // namespace flatray
