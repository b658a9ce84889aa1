#include "image/pixel_runs.h"

#include <gtest/gtest.h>

#include <vector>

#include "base/philox.h"
#include "image/srgb.h"
#include "pictures.h"

namespace flatray {
namespace {

const Light kLight{0.05F, 0.4F, 0.21F, 0.7F};

// One pixel alone.
Image developed(const Light& light, int channels) {
  Image image = flat(1, 1, channels, 0);
  put_rows(std::span(&light, 1), 1, 0, 0, image);
  return image;
}

// Runs of equal pixels between noise, as a picture of shapes has them.
std::vector<Light> runs(std::size_t count) {
  std::vector<Light> colours(count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t c = 0; c < 4; ++c)
      colours[i][c] = static_cast<float>(unit_double(random_bits(1, Stream::test, i * i / 300, c)));
  return colours;
}

TEST(PutRun, WritesSoManyPixelsAndNothingElse) {
  for (const int channels : {3, 4}) {
    const std::vector<std::uint8_t> pixel = developed(kLight, channels).pixels;
    const ShownColour colour = shown_colour(kLight, channels);
    for (std::size_t count = 1; count < 70; ++count) {
      const std::size_t size = static_cast<std::size_t>(channels) * count;
      std::vector<std::uint8_t> bytes(size + 20, 7);
      put_run(colour, size, bytes.data() + 10);
      for (std::size_t i = 0; i < bytes.size(); ++i) {
        const bool inside = i >= 10 && i < 10 + size;
        ASSERT_EQ(bytes[i], inside ? pixel[(i - 10) % pixel.size()] : 7) << count << ' ' << i;
      }
    }
  }
}

TEST(PutPixels, DevelopsEachIntoItsPlace) {
  const std::array lights{kLight, Light{1, 0.5F, 0, 1}};
  const std::array<std::uint32_t, 2> places{4, 1};
  for (const int channels : {3, 4}) {
    Image image = flat(5, 1, channels, 9), expected = image;
    put_pixels(lights, places, channels, image.at(0, 0));
    for (std::size_t i = 0; i < lights.size(); ++i)
      std::copy_n(developed(lights[i], channels).pixels.data(), channels,
                  expected.at(static_cast<int>(places[i]), 0));
    EXPECT_EQ(image, expected);
  }
}

TEST(PutRows, EachPixelIsDevelopedAsIfAlone) {
  const std::vector<Light> colours = runs(61 * 7);
  Image opaque(61, 7, 3), straight(61, 7, 4);
  put_rows(colours, 61, 0, 0, opaque);
  put_rows(colours, 61, 0, 0, straight);
  for (int y = 0; y < 7; ++y)
    for (int x = 0; x < 61; ++x) {
      const Light& light = colours[static_cast<std::size_t>(61 * y + x)];
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_EQ(opaque.at(x, y)[c], srgb_from_linear(light[c]));
        EXPECT_EQ(straight.at(x, y)[c], srgb_from_linear(light[c] / light[3]));
      }
    }
}

TEST(PutRows, WritesItsPlaceAndNothingElse) {
  const std::vector<Light> white(6, Light{1, 1, 1, 1});
  for (const int channels : {3, 4}) {
    Image image = flat(5, 4, channels, 9);
    put_rows(white, 3, 1, 2, image);
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 5; ++x)
        EXPECT_EQ(*image.at(x, y), y >= 2 && x >= 1 && x <= 3 ? 255 : 9) << x << ' ' << y;
  }
}

TEST(PutRows, AlphaIsStraightAndRoundedHalvesUp) {
  using Pixels = std::vector<std::uint8_t>;
  const auto pixel = [](const Light& light) { return developed(light, 4).pixels; };
  EXPECT_EQ(pixel({0.25F, 0.5F, 0, 0.5F}), (Pixels{188, 255, 0, 128}));  // alpha 127.5
  EXPECT_EQ(pixel({0, 0, 0, 0}), (Pixels{0, 0, 0, 0}));
  EXPECT_EQ(pixel({0.001F, 0, 0, 0.001F}), (Pixels{0, 0, 0, 0}));  // alpha 0.255: not seen
  EXPECT_EQ(pixel({0.01F, 0, 0, 0.01F}), (Pixels{255, 0, 0, 3}));
  EXPECT_EQ(pixel({1, 1, 1, 1}), (Pixels{255, 255, 255, 255}));
}

TEST(PutRows, NegativeZeroAndZeroAreTheSameBlack) {
  EXPECT_EQ(developed({-0.0F, 0, -0.0F, 1}, 3), flat(1, 1, 3, 0));
}

TEST(PutRows, LinearPicturesGetTheLightUnchanged) {
  const std::vector<Light> colours = runs(4 * 3);
  LinearImage image{6, 4, std::vector<float>(72, -1.0F)};
  put_rows(colours, 4, 2, 1, image);
  for (std::size_t y = 0; y < 4; ++y)
    for (std::size_t x = 0; x < 6; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_EQ(image.pixels[3 * (6 * y + x) + c],
                  x >= 2 && y >= 1 ? colours[4 * (y - 1) + x - 2][c] : -1.0F);
}

}  // namespace
}  // namespace flatray
