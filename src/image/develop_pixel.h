#pragma once
#include <algorithm>
#include <array>
#include <cstring>

#include "image/srgb_encoder.h"

/// One pixel of linear premultiplied RGBA as 8 bits a channel, for the loops of this module.
namespace flatray {

// Nearest of 256 levels, halves up; exact, as a float times 255 fits a double.
inline std::uint8_t level(float share) {
  const double levels = 255.0 * static_cast<double>(share) + 0.5;
  return static_cast<std::uint8_t>(levels > 0 ? std::min(levels, 255.0) : 0.0);
}

using Rgb = std::array<std::uint8_t, 3>;

// Written out: the three hide each other's latency.
inline Rgb encode_light(const SrgbEncoder& encode, float r, float g, float b) {
  return {encode(r), encode(g), encode(b)};
}

/// Over an opaque background.
struct Opaque {
  static constexpr int kChannels = 3;
  static void pixel(const float* rgba, const SrgbEncoder& encode, std::uint8_t* out) {
    const Rgb rgb = encode_light(encode, rgba[0], rgba[1], rgba[2]);
    std::memcpy(out, rgb.data(), rgb.size());
  }
};

/// Straight alpha.
struct Straight {
  static constexpr int kChannels = 4;
  static void pixel(const float* rgba, const SrgbEncoder& encode, std::uint8_t* out) {
    const float alpha = rgba[3];
    const std::uint8_t shown = level(alpha);
    const Rgb rgb = shown == 0
                        ? Rgb{}
                        : encode_light(encode, rgba[0] / alpha, rgba[1] / alpha, rgba[2] / alpha);
    std::memcpy(out, rgb.data(), rgb.size());
    out[3] = shown;
  }
};

}  // namespace flatray
