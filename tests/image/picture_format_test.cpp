#include "image/picture_format.h"

#include <gtest/gtest.h>

#include <set>

#include "image/y4m.h"
#include "pictures.h"

namespace flatray {
namespace {

using Bytes = PictureFormat::Bytes;

LinearImage plain_ramp(int width, int height) {
  LinearImage image{width, height, {}};
  for (int i = 0; i < 3 * width * height; ++i) image.pixels.push_back(static_cast<float>(i) / 8);
  return image;
}

FilmFile small_film() {
  FilmFile film;
  film.setting = "{}", film.width = 2, film.height = 1, film.round_unit = 1;
  film.scrambles.push_back({0, std::vector<std::int64_t>(6)});
  return film;
}

Bytes encoded(const PictureFormat& format) {
  if (format.of_film != nullptr) return format.of_film(small_film());
  if (format.of_light != nullptr) return format.of_light(plain_ramp(4, 3));
  const Bytes picture = format.encode(noise(4, 3, 3));
  return format.is_video() ? format.part(picture, 0, {4, 3, 1, 24}) : picture;
}

TEST(PictureFormats, EachIsFoundByItsNameAndHoldsOneThing) {
  std::set<std::string> names;
  for (const PictureFormat* format : picture_formats()) {
    EXPECT_TRUE(names.insert(format->name).second) << format->name << " stands there twice";
    EXPECT_EQ(find_picture_format(format->name), format);
    EXPECT_EQ((format->of_picture != nullptr) + (format->of_light != nullptr) +
                  (format->of_film != nullptr),
              1)
        << format->name;
    EXPECT_FALSE(format->beginning.empty()) << format->name;
    EXPECT_TRUE(!format->is_video() || format->of_picture != nullptr) << format->name;
    EXPECT_TRUE(format->by_ffmpeg.empty() || format->part == &y4m_part) << format->name;
  }
  EXPECT_EQ(find_picture_format("PNG"), nullptr);
  EXPECT_EQ(find_picture_format(""), nullptr);
}

// By this Outputs tells whether a file may be replaced by another of its kind.
TEST(PictureFormats, AFileBeginsAsItsFormatSaysAndIsKnownByIt) {
  for (const PictureFormat* format : picture_formats()) {
    if (!format->by_ffmpeg.empty()) continue;
    const Bytes bytes = encoded(*format);
    const PictureFormat* known = picture_format_of(bytes);
    ASSERT_NE(known, nullptr) << format->name;
    EXPECT_EQ(known->beginning, format->beginning) << format->name;
  }
  EXPECT_EQ(picture_format_of({}), nullptr);
}

TEST(PictureFormats, WhatIsReadBackIsWhatWasWritten) {
  for (const PictureFormat* format : picture_formats()) {
    if (format->read_picture != nullptr) {
      const auto read = format->read_picture(encoded(*format), "x");
      ASSERT_TRUE(read) << format->name;
      EXPECT_TRUE(*read == noise(4, 3, 3)) << format->name;
    }
    if (format->read_light != nullptr) {
      const auto read = format->read_light(encoded(*format), "x");
      ASSERT_TRUE(read) << format->name;
      EXPECT_EQ(read->width, 4);
      EXPECT_EQ(read->pixels[3], 0.375F) << format->name;
    }
  }
}

}  // namespace
}  // namespace flatray
