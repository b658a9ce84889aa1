#include "image/tile.h"

#include <gtest/gtest.h>

#include <array>

#include "base/philox.h"
#include "image/srgb.h"
#include "pictures.h"

namespace flatray {
namespace {

Tile tile_of(int x, int y, int width, int height) {
  Tile tile{x, y, width, height, {}};
  tile.rgba.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  return tile;
}

void fill(Tile& tile, std::array<float, 4> rgba) {
  for (std::size_t i = 0; i < tile.rgba.size(); ++i) tile.rgba[i] = rgba[i % 4];
}

// Runs of equal pixels between noise, as a picture of shapes has them.
Tile runs(int width, int height) {
  Tile tile = tile_of(0, 0, width, height);
  for (std::size_t i = 0; i < tile.rgba.size(); ++i) {
    const std::uint64_t run = (i / 4) * (i / 4) / 300;
    tile.rgba[i] = static_cast<float>(unit_double(random_bits(1, Stream::test, run, i % 4)));
  }
  return tile;
}

TEST(Develop, EachPixelIsDevelopedAsIfAlone) {
  const Tile tile = runs(61, 7);
  Image opaque(61, 7, 3), straight(61, 7, 4);
  develop(tile, opaque);
  develop(tile, straight);
  for (int y = 0; y < 7; ++y)
    for (int x = 0; x < 61; ++x) {
      const float* rgba = tile.row(y) + 4 * x;
      for (int c = 0; c < 3; ++c) {
        EXPECT_EQ(opaque.at(x, y)[c], srgb_from_linear(rgba[c]));
        EXPECT_EQ(straight.at(x, y)[c], srgb_from_linear(rgba[c] / rgba[3]));
      }
    }
}

TEST(Develop, NeighboursThatDifferInOneChannelAreDevelopedEach) {
  for (std::size_t channel = 0; channel < 4; ++channel) {
    Tile tile = tile_of(0, 0, 2, 1);
    fill(tile, {0.25F, 0.25F, 0.25F, 0.75F});
    tile.rgba[4 + channel] = 0.5F;
    Image image(2, 1, 4);
    develop(tile, image);
    EXPECT_FALSE(std::equal(image.at(0, 0), image.at(0, 0) + 4, image.at(1, 0))) << channel;
  }
}

TEST(Develop, WritesItsPlaceAndNothingElse) {
  for (const int channels : {3, 4}) {
    Image image = flat(5, 4, channels, 9);
    Tile tile = tile_of(1, 2, 3, 1);
    fill(tile, {1, 1, 1, 1});
    develop(tile, image);
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 5; ++x)
        EXPECT_EQ(*image.at(x, y), y == 2 && x >= 1 && x <= 3 ? 255 : 9) << x << ' ' << y;
  }
}

TEST(Develop, AlphaIsStraightAndRoundedHalvesUp) {
  const auto develop_one = [](std::array<float, 4> rgba) {
    Tile tile = tile_of(0, 0, 1, 1);
    fill(tile, rgba);
    Image image(1, 1, 4);
    develop(tile, image);
    return image.pixels;
  };
  using Pixels = std::vector<std::uint8_t>;
  EXPECT_EQ(develop_one({0.25F, 0.5F, 0, 0.5F}), (Pixels{188, 255, 0, 128}));  // alpha 127.5
  EXPECT_EQ(develop_one({0, 0, 0, 0}), (Pixels{0, 0, 0, 0}));
  EXPECT_EQ(develop_one({0.001F, 0, 0, 0.001F}), (Pixels{0, 0, 0, 0}));  // alpha 0.255: not seen
  EXPECT_EQ(develop_one({0.01F, 0, 0, 0.01F}), (Pixels{255, 0, 0, 3}));
  EXPECT_EQ(develop_one({1, 1, 1, 1}), (Pixels{255, 255, 255, 255}));
}

TEST(Develop, NegativeZeroAndZeroAreTheSameBlack) {
  Tile tile = tile_of(0, 0, 3, 1);
  fill(tile, {0, 0, 0, 1});
  tile.rgba[4] = -0.0F;
  Image image = flat(3, 1, 3, 1);
  develop(tile, image);
  EXPECT_EQ(image, flat(3, 1, 3, 0));
}

TEST(Develop, LinearPicturesGetTheLightUnchanged) {
  const Tile tile = [] {
    Tile t = runs(4, 3);
    t.x = 2, t.y = 1;
    return t;
  }();
  LinearImage image{6, 4, std::vector<float>(72, -1.0F)};
  develop(tile, image);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 6; ++x)
      for (int c = 0; c < 3; ++c) {
        const bool inside = x >= 2 && y >= 1;
        const float expected = inside ? tile.row(y - 1)[4 * (x - 2) + c] : -1.0F;
        EXPECT_EQ(image.pixels[static_cast<std::size_t>(3 * (6 * y + x) + c)], expected);
      }
}

}  // namespace
}  // namespace flatray
