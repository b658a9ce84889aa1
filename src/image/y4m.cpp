#include "image/y4m.h"

#include <fmt/core.h>

#include "image/frame_rate.h"
#include "image/srgb.h"

namespace flatray {
namespace {

// The quotient rounded to the nearest, halves up; `under` is positive.
constexpr std::int32_t rounded(std::int32_t over, std::int32_t under) {
  const std::int32_t sum = over + under / 2;
  return sum >= 0 ? sum / under : -((under - 1 - sum) / under);
}

struct Yuv {
  std::uint8_t y, cb, cr;
};

// Numbers of y4m.h times 10000: all stay below 2^31.
constexpr Yuv yuv_of(std::int32_t red, std::int32_t green, std::int32_t blue) {
  const std::int32_t luma = 2126 * red + 7152 * green + 722 * blue;
  const auto byte = [](std::int32_t value) { return static_cast<std::uint8_t>(value); };
  return {byte(16 + rounded(219 * luma, 255 * 10000)),
          byte(128 + rounded(224 * ((10000 * blue - luma) / 2), 255 * 18556 / 2)),
          byte(128 + rounded(224 * ((10000 * red - luma) / 2), 255 * 15748 / 2))};
}
// The halves above are whole: weights and divisors are even.
static_assert(yuv_of(255, 255, 255).y == 235 && yuv_of(0, 0, 255).cb == 240 &&
              yuv_of(255, 0, 0).cr == 240 && yuv_of(255, 255, 0).cb == 16);

// In linear light, as all that lies over something.
std::int32_t over_black(std::uint8_t value, std::uint8_t alpha) {
  return srgb_from_linear(linear_from_srgb(value) * (static_cast<float>(alpha) / 255));
}

}  // namespace

std::vector<std::byte> y4m_picture(const Image& image, PngEncoder&, const RowsChanged&) {
  const std::size_t count = image.pixels.size() / static_cast<std::size_t>(image.channels);
  std::vector<std::byte> planes(3 * count);
  const std::uint8_t* pixel = image.pixels.data();
  for (std::size_t i = 0; i < count; ++i, pixel += image.channels) {
    const std::uint8_t alpha = image.channels == 4 ? pixel[3] : 255;
    const Yuv yuv = alpha == 255 ? yuv_of(pixel[0], pixel[1], pixel[2])
                                 : yuv_of(over_black(pixel[0], alpha), over_black(pixel[1], alpha),
                                          over_black(pixel[2], alpha));
    planes[i] = std::byte{yuv.y};
    planes[count + i] = std::byte{yuv.cb};
    planes[2 * count + i] = std::byte{yuv.cr};
  }
  return planes;
}

std::vector<std::byte> y4m_part(std::span<const std::byte> planes, std::size_t index,
                                const FrameSequence& sequence) {
  constexpr std::uint32_t kMost = 1'000'000;
  std::string head = "FRAME\n";
  if (index == 0) {
    const Ratio rate = nearest_ratio(sequence.fps, kMost);
    head = fmt::format("{}W{} H{} F{}:{} Ip A1:1 C444 XCOLORRANGE=LIMITED\nFRAME\n", kY4mSignature,
                       sequence.width, sequence.height, rate.over, rate.under);
  }
  const auto line = std::as_bytes(std::span(head));
  std::vector<std::byte> bytes;
  bytes.reserve(line.size() + planes.size());
  bytes.insert(bytes.end(), line.begin(), line.end());
  bytes.insert(bytes.end(), planes.begin(), planes.end());
  return bytes;
}

}  // namespace flatray
