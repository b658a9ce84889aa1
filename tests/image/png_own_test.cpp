// needs: encoders/own
#include <gtest/gtest.h>

#include <algorithm>

#include "image/band_rows.h"
#include "image/deflate.h"
#include "image/png.h"
#include "pictures.h"

namespace flatray {
namespace {

// Deflate names bytes that stand up to 32768 before (RFC 1951, 3.2.5): between two equal words there
// are zeros, so that each is looked at.
TEST(MatchFinder, RepeatsNoBytesFartherBackThanDeflateCanName) {
  const auto longest_distance = [](std::size_t apart) {
    std::vector<std::uint8_t> bytes(apart + 100);
    for (const std::size_t place : {std::size_t{40}, 40 + apart})
      for (std::size_t i = 0; i < 12; ++i) bytes[place + i] = static_cast<std::uint8_t>(17 * i + 1);
    MatchFinder finder;
    std::uint32_t longest = 0;
    for (const Sequence& each : finder.find(bytes, 3)) longest = std::max(longest, each.distance);
    return longest;
  };
  EXPECT_EQ(longest_distance(32767), 32767U);
  EXPECT_EQ(longest_distance(32768), 32768U);
  EXPECT_LE(longest_distance(32769), 3U);
}

// The encoder is told that the second band stays, and it does: its chunk depends on its rows alone.
TEST(PngEncoder, BandsThatStayKeepTheirBytesAndTheFileIsThatOfThePictureAlone) {
  const int rows = band_rows(640);
  Image image = noise(640, 3 * rows - 5, 3);
  PngEncoder encoder(2);
  EXPECT_EQ(encoder.encode(image, [](int, int) { return false; }), encode_png(image))
      << "nothing is kept of no picture";
  for (int x = 0; x < 640; ++x)
    for (int c = 0; c < 3; ++c) {
      ++image.at(x, rows - 1)[c];
      ++image.at(x, 2 * rows)[c];
    }
  const auto changed = [rows](int begin, int) { return begin != rows; };
  EXPECT_EQ(encoder.encode(image, changed), encode_png(image));
  EXPECT_EQ(encoder.packed(), 5U);
  EXPECT_EQ(encoder.kept(), 1U);
}

TEST(PngEncoder, AnotherSizeOrNumberOfChannelsKeepsNothing) {
  PngEncoder encoder(1);
  const auto stays = [](int, int) { return false; };
  for (const Image& image :
       {noise(64, 300, 3), noise(64, 299, 3), noise(96, 299, 3), noise(96, 299, 4)})
    EXPECT_EQ(encoder.encode(image, stays), encode_png(image));
}

}  // namespace
}  // namespace flatray
