#pragma once
#include "base/philox.h"
#include "image/image.h"

namespace flatray {

/// Every byte drawn on its own.
inline Image noise(int width, int height, int channels, std::uint64_t seed = 1) {
  Image image(width, height, channels);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = static_cast<std::uint8_t>(random_bits(seed, Stream::test, 0, i) >> 56);
  return image;
}

/// Every byte the same.
inline Image flat(int width, int height, int channels, std::uint8_t value) {
  Image image(width, height, channels);
  image.pixels.assign(image.pixels.size(), value);
  return image;
}

}  // namespace flatray
