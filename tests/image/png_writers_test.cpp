#include <gtest/gtest.h>

#include "image/png.h"
#include "pictures.h"

namespace flatray {
namespace {

Image grey(int width, int height) {
  Image image = noise(width, height, 3);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = image.pixels[i / 3 * 3];
  return image;
}

// Whoever writes it: what is read back is the picture, and so the same for all.
TEST(PngWriters, AllWriteWhatDecodesToThePicture) {
  ASSERT_FALSE(png_writers().empty());
  for (const Image& image : {grey(40, 30), noise(40, 30, 3), noise(40, 30, 4), noise(1, 1, 3),
                             noise(1, 1, 4), flat(300, 200, 3, 77), flat(300, 200, 4, 0),
                             noise(100000, 1, 3), noise(1, 100000, 4), noise(20000, 2, 3)})
    for (const PngWriter* writer : png_writers()) {
      const auto read = decode_png(
          PngEncoder(2, *writer).encode(image, [](int, int) { return true; }), writer->name);
      ASSERT_TRUE(read) << format(read.error());
      EXPECT_TRUE(*read == image) << writer->name << " " << image.width << " x " << image.height
                                  << " x " << image.channels;
    }
}

TEST(PngWriters, TheFirstOneWrites) {
  const Image image = noise(50, 40, 3);
  PngEncoder first(1, *png_writers().front());
  EXPECT_EQ(encode_png(image), first.encode(image, [](int, int) { return true; }));
}

// A picture is none of the one before it, whatever a writer keeps.
TEST(PngWriters, PicturesOfASequenceAreThoseOfEachAlone) {
  for (const PngWriter* writer : png_writers()) {
    PngEncoder sequence(1, *writer);
    for (int frame = 0; frame < 3; ++frame) {
      const Image image = noise(64, 300, 3, static_cast<std::uint64_t>(frame));
      const auto all = [](int, int) { return true; };
      EXPECT_EQ(sequence.encode(image, all), PngEncoder(1, *writer).encode(image, all));
    }
  }
}

}  // namespace
}  // namespace flatray
