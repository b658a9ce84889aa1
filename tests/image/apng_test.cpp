// needs: pictures/apng
#include <gtest/gtest.h>

#include "image/checksums.h"
#include "image/picture_format.h"
#include "image/png_chunks.h"
#include "pictures.h"

namespace flatray {
namespace {

using Bytes = PictureFormat::Bytes;

struct Chunk {
  std::string type;
  Bytes data;
};

std::uint32_t number_at(const Bytes& bytes, std::size_t at, std::size_t size = 4) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < size; ++i)
    number = number << 8 | std::to_integer<std::uint32_t>(bytes[at + i]);
  return number;
}

// By ISO/IEC 15948: length, type, data, CRC of type and data.
std::vector<Chunk> chunks_of(const Bytes& file) {
  std::vector<Chunk> chunks;
  for (std::size_t at = kPngSignature.size(); at < file.size();) {
    const std::uint32_t size = number_at(file, at);
    EXPECT_EQ(crc32(std::span(file).subspan(at + 4, size + 4)), number_at(file, at + 8 + size));
    Chunk chunk{"", Bytes(file.begin() + static_cast<std::ptrdiff_t>(at) + 8,
                          file.begin() + static_cast<std::ptrdiff_t>(at + 8 + size))};
    for (std::size_t i = 0; i < 4; ++i) chunk.type += std::to_integer<char>(file[at + 4 + i]);
    chunks.push_back(std::move(chunk));
    at += 12 + size;
  }
  return chunks;
}

class Apng : public ::testing::TestWithParam<int> {
 protected:
  Apng() {
    const PictureFormat& apng = *find_picture_format("apng");
    for (std::size_t i = 0; i < sequence_.frames; ++i) {
      frames_.push_back(noise(31, 300, GetParam(), i));
      const Bytes part = apng.part(apng.encode(frames_.back()), i, sequence_);
      file_.insert(file_.end(), part.begin(), part.end());
    }
  }
  const FrameSequence sequence_{31, 300, 4, 29.97};
  std::vector<Image> frames_;
  Bytes file_;
};

TEST_P(Apng, ChunksAreThoseOfTheStandardInOrder) {
  std::string types;
  std::uint32_t next = 0;
  for (const auto& [type, data] : chunks_of(file_)) {
    types += type + " ";
    if (type == "acTL") {
      EXPECT_EQ(number_at(data, 0), 4U) << "frames";
      EXPECT_EQ(number_at(data, 4), 0U) << "for ever";
    }
    if (type == "fcTL" || type == "fdAT") {
      EXPECT_EQ(number_at(data, 0), next++);
    }
    if (type != "fcTL") continue;
    EXPECT_EQ(number_at(data, 4), 31U);
    EXPECT_EQ(number_at(data, 8), 300U);
    EXPECT_EQ(number_at(data, 20, 2), 100U) << "seconds of a frame: 100/2997";
    EXPECT_EQ(number_at(data, 22, 2), 2997U);
    EXPECT_EQ(number_at(data, 24, 2), 0U);
  }
  EXPECT_EQ(types, "IHDR acTL fcTL IDAT fcTL fdAT fcTL fdAT fcTL fdAT IEND ");
}

// Each frame's rows, put into a plain PNG, are its picture; the file read as a PNG is the first.
TEST_P(Apng, EveryFrameComesBackAsItWas) {
  const auto chunks = chunks_of(file_);
  std::size_t frame = 0;
  for (const auto& [type, data] : chunks) {
    if (type != "IDAT" && type != "fdAT") continue;
    Bytes png(file_.begin(), file_.begin() + 33);
    PngChunk rows(png, "IDAT");
    png.insert(png.end(), data.begin() + (type == "fdAT" ? 4 : 0), data.end());
    rows.end();
    PngChunk(png, "IEND").end();
    const auto read = decode_png(png, "frame");
    ASSERT_TRUE(read) << format(read.error());
    EXPECT_TRUE(*read == frames_[frame++]);
  }
  EXPECT_EQ(frame, 4U);
  const auto animated = decode_png(file_, "file");
  ASSERT_FALSE(animated);
  EXPECT_NE(format(animated.error()).find("an animated PNG of 4 frames"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Channels, Apng, ::testing::Values(3, 4));

}  // namespace
}  // namespace flatray
