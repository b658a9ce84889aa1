#include "app/report/difference_text.h"

#include <fmt/core.h>

#include <array>

#include "base/counted.h"

namespace flatray {

std::string difference_text(const Difference& difference) {
  constexpr std::array<const char*, 4> kChannels = {"red", "green", "blue", "alpha"};
  return fmt::format("worst pixel ({}, {}) {}: {}, expected {}; {} of {} differ{}", difference.x,
                     difference.y, kChannels[static_cast<std::size_t>(difference.channel)],
                     static_cast<float>(difference.actual), static_cast<float>(difference.expected),
                     difference.pixels, counted(difference.of, "pixel"),
                     difference.pixels == 1 ? "s" : "");
}

}  // namespace flatray
