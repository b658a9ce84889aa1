#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "scene/scene.h"

namespace flatray {

/// Something that a build lacks, and what that is to a scene.
struct MissingPart {
  std::string name;
  bool concerns = false;  ///< the scene could use it
  std::string reason;
};
std::vector<MissingPart> missing_parts(const Scene& scene,
                                       std::span<const std::string_view> left_out);

/// Error   Trouble::unavailable for each pass left out that the scene needs: its pictures would
///         lack something.
Result<void> can_draw(const Scene& scene, std::span<const std::string_view> left_out);

}  // namespace flatray
