#include "image/image.h"

#include <gtest/gtest.h>

#include <set>

#include "pictures.h"

namespace flatray {
namespace {

TEST(Image, PixelsLieRowByRowFromTheTop) {
  Image image(3, 2, 4);
  *image.at(1, 1) = 7;
  EXPECT_EQ(image.pixels.size(), 24U);
  EXPECT_EQ(image.pixels[(1 * 3 + 1) * 4], 7);
}

TEST(PixelHash, AnyByteChangesIt) {
  Image image = noise(5, 3, 3);  // 45 bytes: one whole block of 32, and a rest
  std::set<std::string> hashes = {pixel_hash(image)};
  for (std::uint8_t& byte : image.pixels) {
    for (const int bit : {1, 128}) {
      byte = static_cast<std::uint8_t>(byte ^ bit);
      hashes.insert(pixel_hash(image));
      byte = static_cast<std::uint8_t>(byte ^ bit);
    }
  }
  EXPECT_EQ(hashes.size(), 1 + 2 * image.pixels.size());
}

TEST(PixelHash, TwoChangesDoNotCancel) {
  Image image = flat(64, 1, 4, 0);
  const std::string before = pixel_hash(image);
  image.pixels[7] = image.pixels[39] = 128;  // the top bits of two words of one lane
  EXPECT_NE(pixel_hash(image), before);
}

TEST(PixelHash, TellsLayoutsOfTheSameBytesApart) {
  Image wide = flat(12, 1, 3, 9), tall = flat(1, 12, 3, 9), alpha = flat(9, 1, 4, 9);
  EXPECT_EQ(wide.pixels, tall.pixels);
  EXPECT_EQ(wide.pixels, alpha.pixels);
  EXPECT_EQ((std::set{pixel_hash(wide), pixel_hash(tall), pixel_hash(alpha)}.size()), 3U);
}

TEST(PixelHash, IsSixteenDigitsAndNeverChanges) {
  EXPECT_EQ(pixel_hash(flat(4, 4, 3, 200)), "90b5430677f0f1f7");  // part of every manifest written
}

}  // namespace
}  // namespace flatray
