#pragma once
#include <span>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace flatray {

/// What this build was configured without: optional packages by the names of their options ("GL",
/// "MPFR", "EMBREE"), registered entries as folder/name ("shapes/circle").
std::vector<std::string> left_out_of_build();

/// Something that a build lacks, and what that is to a scene.
struct MissingPart {
  std::string name;
  bool concerns = false;  ///< the scene could use it
  std::string reason;
};
std::vector<MissingPart> missing_parts(const Scene& scene, std::span<const std::string> left_out);

}  // namespace flatray
