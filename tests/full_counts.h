#pragma once
#include <cstdint>
#include <cstdlib>

namespace flatray {

/// Whether the tests are run at the counts of the goals, which takes half an hour and more:
/// FLATRAY_FULL_COUNTS is set.
inline bool at_full_counts() { return std::getenv("FLATRAY_FULL_COUNTS") != nullptr; }

/// How often: as the goal says, or as often as every run can afford.
inline std::uint64_t times(std::uint64_t full, std::uint64_t quick) {
  return at_full_counts() ? full : quick;
}

}  // namespace flatray
