#pragma once
#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>

#include "image/image.h"

namespace flatray {

/// Linear premultiplied RGBA.
using Light = std::array<float, 4>;

/// A colour as the pixels of a picture hold it, over and over: ready to be written in runs.
struct ShownColour {
  static constexpr std::size_t kBytes = 48;  ///< whole pixels of 3 and of 4 channels
  std::uint8_t bytes[kBytes];
};

/// A colour as pixels of 8 bits a channel: 3 channels over an opaque background, 4 with straight alpha.
ShownColour shown_colour(const Light& light, int channels);

/// Writes `count` > 0 bytes of whole pixels.
// By stores of fixed size that overlap: the pattern has the right phase at any offset.
inline void put_run(const ShownColour& colour, std::size_t count, std::uint8_t* out) {
  const auto put = [&](std::size_t at, auto size) {
    std::memcpy(out + at, colour.bytes + at, decltype(size)::value);
  };
  constexpr std::size_t kAll = ShownColour::kBytes;
  if (count >= kAll) {
    const ShownColour kept = colour;  // no store changes it
    std::uint8_t* const last = out + count - kAll;
    for (; out < last; out += kAll) std::memcpy(out, kept.bytes, kAll);
    std::memcpy(last, kept.bytes, kAll);
  } else if (count >= 16) {
    put(0, std::integral_constant<std::size_t, 16>{});
    if (count > 32) put(16, std::integral_constant<std::size_t, 16>{});
    put(count - 16, std::integral_constant<std::size_t, 16>{});
  } else if (count >= 8) {
    put(0, std::integral_constant<std::size_t, 8>{});
    put(count - 8, std::integral_constant<std::size_t, 8>{});
  } else {
    put(0, std::integral_constant<std::size_t, 3>{});
    put(count - 3, std::integral_constant<std::size_t, 3>{});
  }
}

/// Develops colour i into pixel `places[i]`, counted in memory order from `first`.
void put_pixels(std::span<const Light> colours, std::span<const std::uint32_t> places, int channels,
                std::uint8_t* first);

/// Develops rows of `width` > 0 colours into a picture, the first at (x, y); of a linear one their light.
void put_rows(std::span<const Light> colours, int width, int x, int y, Image& out);
void put_rows(std::span<const Light> colours, int width, int x, int y, LinearImage& out);

}  // namespace flatray
