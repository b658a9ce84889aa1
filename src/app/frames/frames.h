#pragma once
#include <string_view>
#include <vector>

#include "base/result.h"
#include "scene/keys/build_scene.h"

namespace flatray {

/// "1..240:2,300" is every second frame from 1 to 240, and 300: sorted, each once.
/// Error   Trouble::usage for anything else, frame 0, and numbers beyond kLastFrame.
Result<std::vector<unsigned>> parse_frames(std::string_view text, const Place& where);

/// Part I of N of a list of frames, I from 0.
struct Shard {
  unsigned index = 0, count = 1;
};
/// "I/N" with 0 <= I < N.
Result<Shard> parse_shard(std::string_view text, const Place& where);

/// Every N-th frame of the list from the I-th on: neighbours cost alike, so the shards do too. The
/// shards of one list are disjoint and make up the list.
std::vector<unsigned> frames_of(const Shard& shard, const std::vector<unsigned>& frames);

}  // namespace flatray
