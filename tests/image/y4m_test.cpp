// needs: pictures/y4m
#include "image/y4m.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "image/frame_rate.h"
#include "pictures.h"

namespace flatray {
namespace {

using Bytes = std::vector<std::byte>;
using Yuv = std::array<int, 3>;

Image of_one_pixel(std::vector<std::uint8_t> channels) {
  Image image(1, 1, static_cast<int>(channels.size()));
  image.pixels = std::move(channels);
  return image;
}

Bytes planes_of(const Image& image) {
  PngEncoder unused(1);
  return y4m_picture(image, unused, {});
}

Yuv yuv(std::vector<std::uint8_t> channels) {
  const Bytes planes = planes_of(of_one_pixel(std::move(channels)));
  return {std::to_integer<int>(planes[0]), std::to_integer<int>(planes[1]),
          std::to_integer<int>(planes[2])};
}

// ITU-R BT.709, 8 bits, limited range: 219 steps of luma from 16, 224 of colour about 128.
TEST(Y4m, PrimaryColoursBlackAndWhiteHaveTheValuesOfBt709) {
  EXPECT_EQ(yuv({0, 0, 0}), (Yuv{16, 128, 128}));
  EXPECT_EQ(yuv({255, 255, 255}), (Yuv{235, 128, 128}));
  EXPECT_EQ(yuv({255, 0, 0}), (Yuv{63, 102, 240}));
  EXPECT_EQ(yuv({0, 255, 0}), (Yuv{173, 42, 26}));
  EXPECT_EQ(yuv({0, 0, 255}), (Yuv{32, 240, 118}));
  EXPECT_EQ(yuv({255, 255, 0}), (Yuv{219, 16, 138}));
  for (int grey = 0; grey < 256; ++grey) {
    const auto value = static_cast<std::uint8_t>(grey);
    EXPECT_EQ(yuv({value, value, value}), (Yuv{16 + (438 * grey + 255) / 510, 128, 128}));
  }
}

TEST(Y4m, EveryColourIsTheNearestToItsFormula) {
  for (int red = 0; red < 256; red += 15)
    for (int green = 0; green < 256; green += 17)
      for (int blue = 0; blue < 256; blue += 5) {
        const double luma = 0.2126 * red + 0.7152 * green + 0.0722 * blue;
        const auto byte = [](int value) { return static_cast<std::uint8_t>(value); };
        const Yuv got = yuv({byte(red), byte(green), byte(blue)});
        constexpr double kHalf = 0.5 + 1e-9;
        EXPECT_LE(std::abs(got[0] - (16 + 219 * luma / 255)), kHalf);
        EXPECT_LE(std::abs(got[1] - (128 + 224 * (blue - luma) / (255 * 1.8556))), kHalf);
        EXPECT_LE(std::abs(got[2] - (128 + 224 * (red - luma) / (255 * 1.5748))), kHalf);
      }
}

TEST(Y4m, WhatIsClearLiesOverBlack) {
  EXPECT_EQ(yuv({255, 255, 255, 0}), yuv({0, 0, 0}));
  EXPECT_EQ(yuv({255, 100, 0, 255}), yuv({255, 100, 0}));
  EXPECT_EQ(yuv({255, 255, 255, 51}), yuv({124, 124, 124}));  // a fifth of the light
  EXPECT_EQ(yuv({255, 255, 255, 128}), yuv({188, 188, 188}));
}

// Read as a video program reads it: a line of header, a line before each frame, three planes.
TEST(Y4m, AStreamIsReadBackFrameByFrame) {
  const FrameSequence sequence{5, 4, 3, 29.97};
  Bytes file;
  std::vector<Bytes> planes;
  for (std::size_t i = 0; i < sequence.frames; ++i) {
    planes.push_back(planes_of(noise(5, 4, 3, i)));
    const Bytes part = y4m_part(planes.back(), i, sequence);
    file.insert(file.end(), part.begin(), part.end());
  }
  std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
  const auto take_line = [&] {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(line.size() + 1);
    return line;
  };
  EXPECT_EQ(take_line(), "YUV4MPEG2 W5 H4 F2997:100 Ip A1:1 C444 XCOLORRANGE=LIMITED");
  for (const Bytes& one : planes) {
    EXPECT_EQ(take_line(), "FRAME");
    ASSERT_GE(text.size(), one.size());
    EXPECT_EQ(text.substr(0, 60),
              std::string_view(reinterpret_cast<const char*>(one.data()), one.size()));
    text.remove_prefix(60);
  }
  EXPECT_TRUE(text.empty());
}

TEST(FrameRate, NumbersAreTheSimpleRatiosThatTheyCameFrom) {
  const auto is = [](double value, std::uint32_t most, std::uint32_t over, std::uint32_t under) {
    const Ratio ratio = nearest_ratio(value, most);
    EXPECT_EQ(ratio.over, over) << value;
    EXPECT_EQ(ratio.under, under) << value;
  };
  is(24, 1000, 24, 1);
  is(0.5, 1000, 1, 2);
  is(29.97, 1'000'000, 2997, 100);
  is(24000.0 / 1001, 65535, 24000, 1001);
  is(3.14159265358979, 1000, 355, 113);
  is(1e300, 65535, 65535, 1);
  is(1e-300, 65535, 1, 65535);
}

}  // namespace
}  // namespace flatray
