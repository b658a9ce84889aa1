#pragma once
#include <optional>
#include <vector>

#include "app/frames/render_job.h"
#include "app/options/arguments.h"
#include "app/options/option_values.h"

namespace flatray {

/// What all scenes of one `flatray render` share.
struct RenderRequest {
  std::optional<FilmSize> size;
  std::optional<std::vector<unsigned>> frames;
  Shard shard;
  unsigned threads = 1;
  bool resume = false;
};

/// Error   Trouble::usage: every option that is wrong by itself, before any file is read.
Result<RenderRequest> read_request(const Arguments& arguments);

/// A job for each scene. All are read before the first picture: one mistake, and nothing is
/// rendered. Error   all mistakes of all scenes; Trouble::usage where pattern, frames and scenes do
/// not fit together.
Result<std::vector<RenderJob>> make_jobs(const Arguments& arguments, const RenderRequest& request);

}  // namespace flatray
