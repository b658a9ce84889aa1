#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"

namespace flatray {

/// 8-bit sRGB picture, rows top-down, straight alpha.
struct Image {
  int width = 0, height = 0, channels = 3;  ///< 3: RGB, 4: RGBA
  std::vector<std::uint8_t> pixels;         ///< width * height * channels

  Image() = default;
  Image(int width_, int height_, int channels_);
  const std::uint8_t* at(int x, int y) const;
  std::uint8_t* at(int x, int y);
  bool operator==(const Image&) const = default;
};

/// 16 hexadecimal digits that name size, channels and pixels.
std::string pixel_hash(const Image& image);

/// Linear RGB picture, rows top-down, 3 floats a pixel: what `.hdr` holds.
struct LinearImage {
  int width = 0, height = 0;
  std::vector<float> pixels;
};

}  // namespace flatray
