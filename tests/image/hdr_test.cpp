#include "image/hdr.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace flatray {
namespace {

// The pixels of a picture too narrow for run lengths (under 8): four bytes each, behind the header.
std::vector<float> read_narrow_hdr(const std::vector<std::byte>& bytes, std::size_t pixels) {
  std::vector<float> light;
  for (std::size_t i = bytes.size() - 4 * pixels; i < bytes.size(); i += 4)
    for (std::size_t c = 0; c < 3; ++c)
      light.push_back(
          std::ldexp(static_cast<float>(bytes[i + c]), std::to_integer<int>(bytes[i + 3]) - 136));
  return light;
}

TEST(Hdr, KeepsLightToOnePartIn128OfTheBrightestChannel) {
  const LinearImage image{3, 1, {1, 0.5F, 0.25F, 1000, 3, 1e-3F, 1e-20F, 0, 2e-20F}};
  const auto read = read_narrow_hdr(encode_hdr(image), 3);
  for (std::size_t i = 0; i < read.size(); ++i) {
    const std::size_t pixel = i / 3 * 3;
    const float brightest =
        std::max({image.pixels[pixel], image.pixels[pixel + 1], image.pixels[pixel + 2]});
    EXPECT_NEAR(read[i], image.pixels[i], brightest / 128) << i;
  }
}

TEST(Hdr, NamesItsFormatAndSize) {
  const auto bytes = encode_hdr({3, 2, std::vector<float>(18, 0.5F)});
  const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  EXPECT_EQ(text.rfind("#?RADIANCE\n", 0), 0U);
  EXPECT_NE(text.find("FORMAT=32-bit_rle_rgbe\n"), std::string::npos);
  EXPECT_NE(text.find("-Y 2 +X 3\n"), std::string::npos);
}

TEST(Hdr, WhatTheFormatCannotHoldIsClamped) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kLargest = std::numeric_limits<float>::max();
  const LinearImage image{
      2, 1, {-1, -kInfinity, std::numeric_limits<float>::quiet_NaN(), kInfinity, 0, kLargest}};
  const auto read = read_narrow_hdr(encode_hdr(image), 2);
  EXPECT_EQ(read[0], 0);
  EXPECT_EQ(read[1], 0);
  EXPECT_EQ(read[2], 0);
  EXPECT_EQ(read[3], read[5]);
  EXPECT_GT(read[3], 1e38F);
}

TEST(Hdr, EqualLightMakesShortRows) {
  EXPECT_LT(encode_hdr({1000, 1, std::vector<float>(3000, 0.5F)}).size(), 250U);
}

}  // namespace
}  // namespace flatray
