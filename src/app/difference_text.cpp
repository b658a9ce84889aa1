#include "app/difference_text.h"

#include <fmt/core.h>

#include <array>

#include "base/counted.h"

namespace flatray {

std::string difference_text(const Difference& difference, const Image& image) {
  constexpr std::array<const char*, 4> kChannels = {"red", "green", "blue", "alpha"};
  const auto& [pixels, worst, x, y, channel, actual, expected, mean, rmse, psnr] = difference;
  return fmt::format(
      "worst pixel ({}, {}) {}: {}, expected {}; {} of {} differ{}", x, y,
      kChannels[static_cast<std::size_t>(channel)], actual, expected, pixels,
      counted(image.pixels.size() / static_cast<std::size_t>(image.channels), "pixel"),
      pixels == 1 ? "s" : "");
}

std::string tolerance_text(const Difference& difference) {
  return fmt::format("max={};pixels={}", difference.worst, difference.pixels);
}

}  // namespace flatray
