#include "image/png.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "base/file.h"
#include "base/parallel.h"
#include "image/band_rows.h"
#include "pictures.h"

namespace flatray {
namespace {

using Bytes = std::vector<std::byte>;

void expect_round_trip(const Image& image) {
  const Bytes bytes = encode_png(image);
  const Result<Image> read = decode_png(bytes, "round trip");
  ASSERT_TRUE(read) << format(read.error());
  EXPECT_TRUE(*read == image) << image.width << " x " << image.height << " x " << image.channels;
}

// A PNG chunk, its checksum by the definition: the remainder of the message, bit by bit.
Bytes chunk(const std::string& type, const std::vector<int>& data) {
  Bytes bytes;
  const auto put = [&](std::uint32_t number) {
    for (const int shift : {24, 16, 8, 0}) bytes.push_back(std::byte((number >> shift) & 0xff));
  };
  put(static_cast<std::uint32_t>(data.size()));
  for (const char c : type) bytes.push_back(std::byte(c));
  for (const int value : data) bytes.push_back(std::byte(value));
  std::uint32_t crc = ~0U;
  for (std::size_t i = 4; i < bytes.size(); ++i) {
    crc ^= std::to_integer<std::uint32_t>(bytes[i]);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) * 0xedb88320U);
  }
  put(~crc);
  return bytes;
}

Bytes header(int width, int height, int depth, int colour_type, int interlace = 0) {
  return chunk("IHDR", {width >> 24, (width >> 16) & 255, (width >> 8) & 255, width & 255,
                        height >> 24, (height >> 16) & 255, (height >> 8) & 255, height & 255,
                        depth, colour_type, 0, 0, interlace});
}

// Rows with their filter bytes, as one stored block of a zlib stream.
Bytes pixels(const std::vector<int>& rows) {
  const int size = static_cast<int>(rows.size());
  std::vector<int> stream = {0x78, 1, 1, size & 255, size >> 8, ~size & 255, (~size >> 8) & 255};
  std::uint32_t a = 1, b = 0;
  for (const int value : rows) {
    stream.push_back(value);
    a = (a + static_cast<std::uint32_t>(value)) % 65521;
    b = (b + a) % 65521;
  }
  for (const std::uint32_t sum : {b >> 8, b, a >> 8, a})
    stream.push_back(static_cast<int>(sum & 255));
  return chunk("IDAT", stream);
}

Bytes png(const std::vector<Bytes>& chunks) {
  Bytes all;
  for (const int c : {137, 80, 78, 71, 13, 10, 26, 10}) all.push_back(std::byte(c));
  for (const Bytes& one : chunks) all.insert(all.end(), one.begin(), one.end());
  return all;
}

const Bytes kEnd = chunk("IEND", {});

void expect_refused(const Bytes& bytes, const std::string& why,
                    std::uint64_t max_pixels = 1 << 20) {
  const auto refused = decode_png(bytes, "bad.png", max_pixels);
  ASSERT_FALSE(refused) << why;
  const Diagnostic& error = refused.error().front();
  EXPECT_EQ(error.trouble, Trouble::invalid);
  EXPECT_EQ(error.where.source->name(), "bad.png");
  EXPECT_NE(error.message.find(why), std::string::npos) << error.message;
  EXPECT_FALSE(error.hint.empty());
}

TEST(Png, PicturesComeBackAsTheyWere) {
  for (const int channels : {3, 4})
    for (const auto& [width, height] :
         {std::pair{1, 1}, {1, 17}, {17, 1}, {2, 3}, {31, 33}, {640, 3}}) {
      expect_round_trip(noise(width, height, channels));
      expect_round_trip(flat(width, height, channels, 0));
      expect_round_trip(flat(width, height, channels, 255));
    }
}

TEST(StiffCases, E2LongThinPicturesComeBackAsTheyWere) {
  for (const int channels : {3, 4}) {
    expect_round_trip(noise(100000, 1, channels));
    expect_round_trip(noise(1, 100000, channels));
  }
}

TEST(Png, SamePictureSameBytesOnAnyThread) {
  const Image image = noise(64, 48, 4);
  const Bytes expected = encode_png(image);
  std::vector<Bytes> encoded(16);
  parallel_for(encoded.size(), 4, [&](std::size_t i) { encoded[i] = encode_png(image); });
  for (const Bytes& bytes : encoded) EXPECT_EQ(bytes, expected);
}

TEST(Png, FlatFramesAreSmall) {
  EXPECT_LT(encode_png(flat(1280, 720, 3, 200)).size(),
            40'000U);  // of 2.8 MB of pixels, whichever library packs them
}

// Repetitions of every length and at every distance the packer knows of, and what lies between.
TEST(Png, StripesOfEveryWidthComeBackAsTheyWere) {
  for (int period = 1; period <= 600; period += period < 40 ? 1 : 37)
    for (const int channels : {3, 4}) {
      Image image(601, 5, channels);
      for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] =
            static_cast<std::uint8_t>(i / static_cast<std::size_t>(period) * 97 % 251);
      expect_round_trip(image);
    }
}

TEST(Png, RunsOfEveryLengthComeBackAsTheyWere) {
  Image image(1000, 100, 3);
  std::size_t at = 0;
  for (std::size_t run = 1; at + run < image.pixels.size(); at += run, ++run)
    image.pixels[at] = static_cast<std::uint8_t>(run % 255 + 1);
  expect_round_trip(image);
}

TEST(Png, NoiseThatCannotBePackedHardlyGrows) {
  const Image image = noise(500, 400, 3);
  const std::size_t raw = image.pixels.size() + 400;
  EXPECT_LT(encode_png(image).size(), raw + raw / 1000 + 200);
  expect_round_trip(image);
}

TEST(Png, SamePictureSameBytesWhateverTheThreads) {
  const Image image = flat(1921, 1083, 3, 9);
  const Bytes expected = encode_png(image);
  for (const unsigned threads : {2U, 3U, 7U}) EXPECT_EQ(encode_png(image, threads), expected);
}

TEST(Png, BandsAreWholeTiles) {
  for (int width = 1; width < 200'000; width += 1 + width / 3) {
    EXPECT_EQ(band_rows(width) % tile_rows(width), 0) << width;
    EXPECT_GT(band_rows(width), 0) << width;
  }
}

TEST(Png, EveryTruncationIsRefused) {
  const Bytes whole = encode_png(noise(5, 4, 3));
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_FALSE(decode_png(std::span(whole).first(size), "cut")) << size << " of " << whole.size();
}

TEST(Png, EverySingleBitFlipIsRefused) {
  Bytes bytes = encode_png(noise(5, 4, 4));
  for (std::size_t i = 0; i < bytes.size(); ++i)
    for (int bit = 0; bit < 8; ++bit) {
      bytes[i] ^= std::byte(1 << bit);
      EXPECT_FALSE(decode_png(bytes, "flipped")) << "byte " << i << " bit " << bit;
      bytes[i] ^= std::byte(1 << bit);
    }
}

TEST(Png, GreyAndPaletteAreReadAsColours) {
  const auto read = [](const std::vector<Bytes>& chunks) {
    const auto image = decode_png(png(chunks), "made");
    EXPECT_TRUE(image) << format(image.error());
    return image ? image->pixels : std::vector<std::uint8_t>{};
  };
  using Levels = std::vector<std::uint8_t>;
  EXPECT_EQ(read({header(2, 1, 8, 0), pixels({0, 10, 20}), kEnd}),
            (Levels{10, 10, 10, 20, 20, 20}));
  EXPECT_EQ(read({header(2, 1, 1, 0), pixels({0, 0x40}), kEnd}), (Levels{0, 0, 0, 255, 255, 255}));
  EXPECT_EQ(read({header(1, 1, 8, 4), pixels({0, 10, 20}), kEnd}), (Levels{10, 10, 10, 20}));
  const Bytes palette = chunk("PLTE", {1, 2, 3, 4, 5, 6});
  EXPECT_EQ(read({header(2, 1, 8, 3), palette, pixels({0, 1, 0}), kEnd}),
            (Levels{4, 5, 6, 1, 2, 3}));
  EXPECT_EQ(read({header(2, 1, 8, 3), palette, chunk("tRNS", {7}), pixels({0, 1, 0}), kEnd}),
            (Levels{4, 5, 6, 255, 1, 2, 3, 7}));
  // Beyond the palette: black, whatever lay in memory.
  EXPECT_EQ(read({header(3, 1, 8, 3), palette, pixels({0, 1, 2, 255}), kEnd}),
            (Levels{4, 5, 6, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(read({header(4, 1, 2, 3), palette, pixels({0, 0x1b}), kEnd}),
            (Levels{1, 2, 3, 4, 5, 6, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(
      read({header(1, 1, 8, 2), chunk("tRNS", {0, 1, 0, 2, 0, 3}), pixels({0, 1, 2, 3}), kEnd}),
      (Levels{1, 2, 3, 0}));
  EXPECT_EQ(read({header(1, 1, 8, 2, 1), pixels({0, 1, 2, 3}), kEnd}), (Levels{1, 2, 3}));
}

TEST(Png, InterlacedPicturesOfAnySizeHaveTheBytesTheyNeed) {
  for (int width = 1; width <= 9; ++width)
    for (int height = 1; height <= 9; ++height) {
      std::vector<int> rows;  // 1-byte pixels, each of the seven passes by its definition
      for (const auto& [x, y, dx, dy] : {std::array{0, 0, 8, 8},
                                         {4, 0, 8, 8},
                                         {0, 4, 4, 8},
                                         {2, 0, 4, 4},
                                         {0, 2, 2, 4},
                                         {1, 0, 2, 2},
                                         {0, 1, 1, 2}})
        for (int row = y; row < height; row += dy) {
          if (x < width) rows.push_back(0);
          for (int column = x; column < width; column += dx) rows.push_back(16 * row + column);
        }
      const auto image =
          decode_png(png({header(width, height, 8, 0, 1), pixels(rows), kEnd}), "adam7");
      ASSERT_TRUE(image) << width << " x " << height;
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) EXPECT_EQ(*image->at(x, y), 16 * y + x);
    }
}

TEST(Png, WhatIsNoPngIsRefused) {
  expect_refused({}, "is not a PNG");
  expect_refused(png({}), "ends in the middle");
  expect_refused(png({kEnd}), "does not begin with its header");
  expect_refused(png({header(1, 1, 8, 2), kEnd}), "cannot be unpacked");
  const Bytes one = pixels({0, 1, 2, 3});
  expect_refused(png({header(1, 1, 8, 2), one, chunk("tEXt", {65}), one, kEnd}), "two places");
  expect_refused(png({header(1, 1, 8, 2), one, chunk("CgBI", {1}), kEnd}), "not known");
  expect_refused(png({header(1, 1, 8, 2), one, kEnd, kEnd}), "after its end");
  expect_refused(png({header(1, 1, 8, 2), header(1, 1, 8, 2), one, kEnd}), "not known");
  expect_refused(png({header(1, 1, 8, 3), pixels({0, 0}), kEnd}), "cannot be unpacked");
}

TEST(Png, HeadersAreCheckedBeforeAnythingIsUnpacked) {
  const Bytes one = pixels({0, 1, 2, 3});
  expect_refused(png({header(1, 1, 16, 2), one, kEnd}), "16 bits");
  expect_refused(png({header(0, 1, 8, 2), one, kEnd}), "impossible");
  expect_refused(png({header(1, 0, 8, 2), one, kEnd}), "impossible");
  expect_refused(png({header(1, 1, 3, 0), one, kEnd}), "impossible");
  expect_refused(png({header(1, 1, 4, 2), one, kEnd}), "impossible");
  expect_refused(png({header(1, 1, 8, 5), one, kEnd}), "impossible");
  expect_refused(png({header(1, 1, 8, 2, 2), one, kEnd}), "impossible");
  expect_refused(png({header(1 << 30, 1 << 30, 8, 2), one, kEnd}), "too large");
  expect_refused(png({header(5, 5, 8, 2), one, kEnd}), "too large", 24);
}

TEST(Png, TheChecksumOfThePixelsMustBeRight) {
  const std::vector<int> stored = {0x78, 1, 1, 4, 0, 251, 255, 0, 1, 2, 3, 0, 14, 0, 7};
  EXPECT_TRUE(decode_png(png({header(1, 1, 8, 2), chunk("IDAT", stored), kEnd}), "right"));
  for (std::size_t i = 11; i < 15; ++i) {
    std::vector<int> wrong = stored;
    wrong[i] ^= 1;
    expect_refused(png({header(1, 1, 8, 2), chunk("IDAT", wrong), kEnd}), "cannot be unpacked");
  }
}

TEST(Png, PixelsMustFillThePictureExactly) {
  expect_refused(png({header(2, 1, 8, 2), pixels({0, 1, 2, 3}), kEnd}), "cannot be unpacked");
  expect_refused(png({header(1, 1, 8, 2), pixels({0, 1, 2, 3, 4}), kEnd}), "cannot be unpacked");
  expect_refused(png({header(20000, 10000, 8, 2), pixels({0, 1, 2, 3}), kEnd}),
                 "cannot be unpacked", std::uint64_t{1} << 28);
}

TEST(Png, MissingFilesAreNamed) {
  const auto missing = read_png("no/such/picture.png");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().front().trouble, Trouble::missing);
  EXPECT_EQ(missing.error().front().where.source->name(), "no/such/picture.png");
}

}  // namespace
}  // namespace flatray
