#include "image/pixel_runs.h"

#include <gtest/gtest.h>

#include "image/tile.h"
#include "pictures.h"

namespace flatray {
namespace {

const Light kLight{0.05F, 0.4F, 0.21F, 0.7F};

// One pixel by the way of all tiles.
Image developed(const Light& light, int channels) {
  Image image = flat(1, 1, channels, 0);
  const Tile tile{0, 0, 1, 1, {light.begin(), light.end()}};
  develop(tile, image);
  return image;
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

}  // namespace
}  // namespace flatray
