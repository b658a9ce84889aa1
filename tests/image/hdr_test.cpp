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

TEST(Hdr, KeepsLightToOnePartIn256OfTheBrightestChannel) {
  const LinearImage image{3, 1, {1, 0.5F, 0.25F, 1000, 3, 1e-3F, 1e-20F, 0, 2e-20F}};
  const auto read = read_narrow_hdr(encode_hdr(image), 3);
  for (std::size_t i = 0; i < read.size(); ++i) {
    const std::size_t pixel = i / 3 * 3;
    const float brightest =
        std::max({image.pixels[pixel], image.pixels[pixel + 1], image.pixels[pixel + 2]});
    EXPECT_NEAR(read[i], image.pixels[i], brightest / 256) << i;
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

// With no bits of what it was.
TEST(Hdr, WhatIsFainterThanTheFormatIsBlack) {
  const std::vector<std::byte> black = encode_hdr({1, 1, {0, 0, 0}});
  for (const float faint : {1e-39F, 1e-43F, std::numeric_limits<float>::denorm_min()})
    EXPECT_EQ(encode_hdr({1, 1, {faint, 0, faint}}), black) << faint;
  EXPECT_EQ(read_narrow_hdr(encode_hdr({1, 1, {0x1p-100F, 0, 0}}), 1)[0], 0x1p-100F);
}

LinearImage ramp(int width, int height) {
  LinearImage image{width, height, {}};
  for (int i = 0; i < 3 * width * height; ++i)
    image.pixels.push_back(i % 7 == 0 ? 0.25F : static_cast<float>(i) * 0.01F);
  return image;
}

TEST(Hdr, WhatIsWrittenIsRead) {
  for (const int width : {1, 7, 8, 9, 200, 1000}) {
    const LinearImage image = ramp(width, 3);
    const auto read = decode_hdr(encode_hdr(image), "a.hdr");
    ASSERT_TRUE(read) << format(read.error());
    EXPECT_EQ(read->width, width);
    ASSERT_EQ(read->pixels.size(), image.pixels.size());
    for (std::size_t i = 0; i < read->pixels.size(); ++i) {
      const std::size_t p = i / 3 * 3;
      const float brightest = std::max({image.pixels[p], image.pixels[p + 1], image.pixels[p + 2]});
      EXPECT_NEAR(read->pixels[i], image.pixels[i], brightest / 128) << width << " " << i;
    }
  }
}

// Found by a reviewer: an exponent of 0 is that of black, whatever stands before it.
TEST(Hdr, IsAsOftenTooBrightAsTooDark) {
  LinearImage image{1000, 1, {}};
  for (int i = 0; i < 3000; ++i)
    image.pixels.push_back(1 + static_cast<float>(i / 3) /
                                   999.0F);  // the last one is 2, of the next exponent
  const auto read = decode_hdr(encode_hdr(image), "a.hdr");
  ASSERT_TRUE(read);
  double off = 0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    off += static_cast<double>(read->pixels[i] / image.pixels[i]) - 1;
  EXPECT_NEAR(off / 3000, 0, 2e-5);
  EXPECT_EQ(read->pixels.back(), 2);
}

std::vector<std::byte> file_of(const std::string& lines, std::vector<int> values) {
  std::vector<std::byte> bytes;
  for (const char c : "#?RADIANCE\n" + lines + "FORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n")
    bytes.push_back(static_cast<std::byte>(c));
  for (const int value : values) bytes.push_back(static_cast<std::byte>(value));
  return bytes;
}

TEST(Hdr, ExposureIsTakenBack) {
  const auto of = [](const std::string& lines) {
    const auto read = decode_hdr(file_of(lines, {128, 64, 32, 129}), "a.hdr");
    return read ? read->pixels.front() : -1;
  };
  EXPECT_EQ(of(""), 1);
  EXPECT_EQ(of("EXPOSURE=2.0\n"), 0.5F);
  EXPECT_EQ(of("EXPOSURE= 2\nEXPOSURE=4\n"), 0.125F);
  EXPECT_EQ(of("EXPOSURE=0\n"), -1);
  EXPECT_EQ(of("EXPOSURE=bright\n"), -1);
}

TEST(Hdr, WhatGoesOnOrIsOfTheOldestRunsIsRefused) {
  EXPECT_TRUE(decode_hdr(file_of("", {128, 64, 32, 129}), "a.hdr"));
  EXPECT_FALSE(decode_hdr(file_of("", {128, 64, 32, 129, 0}), "a.hdr"));
  EXPECT_FALSE(decode_hdr(file_of("", {1, 1, 1, 1}), "a.hdr"));
}

TEST(Hdr, AnExponentOfNothingIsBlack) {
  std::vector<std::byte> bytes = encode_hdr({1, 1, {0.5F, 0.5F, 0.5F}});
  bytes.back() = std::byte{0};
  EXPECT_EQ(decode_hdr(bytes, "a.hdr")->pixels, std::vector<float>(3, 0.0F));
}

TEST(Hdr, WhatIsCutShortOrDamagedIsRefused) {
  const std::vector<std::byte> whole = encode_hdr(ramp(20, 4));
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_FALSE(decode_hdr(std::span(whole).first(size), "cut")) << size;
  EXPECT_FALSE(decode_hdr(whole, "large", 79));
  for (std::size_t at = 0; at < whole.size(); ++at)
    for (const int byte : {0, 1, 127, 128, 129, 255}) {
      std::vector<std::byte> damaged = whole;
      damaged[at] = std::byte(byte);
      const auto read = decode_hdr(damaged, "damaged", 10'000);  // refused, or read as something
      if (!read) continue;
      EXPECT_EQ(read->pixels.size(), 3U * static_cast<std::size_t>(read->width * read->height));
    }
}

TEST(Hdr, IsDevelopedAsPngsAre) {
  EXPECT_EQ(develop(LinearImage{2, 1, {0, 1, 4, 0.5F, 0.25F, 0.0F}}).pixels,
            (std::vector<std::uint8_t>{0, 255, 255, 188, 137, 0}));
}

TEST(Hdr, EqualLightMakesShortRows) {
  EXPECT_LT(encode_hdr({1000, 1, std::vector<float>(3000, 0.5F)}).size(), 250U);
}

}  // namespace
}  // namespace flatray
