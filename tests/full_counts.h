#pragma once
#include <cstdint>
#include <cstdlib>

namespace flatray {

/// Whether the tests are run at the counts of the goals, which takes half an hour and more:
/// FLATRAY_FULL_COUNTS is set.
inline bool at_full_counts() { return std::getenv("FLATRAY_FULL_COUNTS") != nullptr; }

/// Whether the address sanitizer watches this program, which then takes ten times as long.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool kSanitized = true;
#elif defined(__has_feature)
inline constexpr bool kSanitized = __has_feature(address_sanitizer);
#else
inline constexpr bool kSanitized = false;
#endif

/// How often: as the goal says, or as often as every run can afford, a sanitized one a fifth of it.
inline std::uint64_t times(std::uint64_t full, std::uint64_t quick) {
  return at_full_counts() ? full : kSanitized ? (quick + 4) / 5 : quick;
}

/// The same for what every run affords as a whole.
inline std::uint64_t times(std::uint64_t all) { return times(all, all); }

}  // namespace flatray
