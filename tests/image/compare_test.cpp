#include "image/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "image/metric.h"
#include "pictures.h"

namespace flatray {
namespace {

TEST(Compare, EqualPicturesDifferInNothing) {
  const Image image = noise(9, 5, 4);
  const Difference none = compare(image, image).value();
  EXPECT_EQ(none.pixels, 0U);
  EXPECT_EQ(none.worst, 0);
  EXPECT_EQ(none.mean, 0);
  EXPECT_EQ(none.rmse, 0);
  EXPECT_EQ(none.psnr, std::numeric_limits<double>::infinity());
}

TEST(Compare, FindsOneLevelInAnyChannelOfAnyPixel) {
  for (const int channels : {3, 4}) {
    const Image expected = noise(7, 5, channels);
    for (std::size_t i = 0; i < expected.pixels.size(); ++i) {
      Image actual = expected;
      actual.pixels[i] = static_cast<std::uint8_t>(actual.pixels[i] ^ 1);
      const Difference found = compare(actual, expected).value();
      const int place = static_cast<int>(i);
      EXPECT_EQ(found.pixels, 1U);
      EXPECT_EQ(found.worst, 1);
      EXPECT_EQ(found.channel, place % channels);
      EXPECT_EQ(found.x, place / channels % 7);
      EXPECT_EQ(found.y, place / channels / 7);
      EXPECT_EQ(found.actual, actual.pixels[i]);
      EXPECT_EQ(found.expected, expected.pixels[i]);
    }
  }
}

TEST(Compare, NamesTheFirstOfEquallyBadPixels) {
  const Image expected = flat(4, 4, 3, 100);
  Image actual = expected;
  actual.at(3, 1)[2] = 90;
  actual.at(1, 2)[0] = 110;
  actual.at(2, 0)[1] = 109;
  const Difference found = compare(actual, expected).value();
  EXPECT_EQ(found.pixels, 3U);
  EXPECT_EQ(found.worst, 10);
  EXPECT_EQ(found.x, 3);
  EXPECT_EQ(found.y, 1);
  EXPECT_EQ(found.channel, 2);
}

TEST(Compare, MeanRmseAndPsnrAreTheirFormulas) {
  const Image black = flat(2, 1, 3, 0);
  Image image = black;
  image.pixels = {3, 0, 0, 0, 4, 5};
  const Difference found = compare(image, black).value();
  EXPECT_EQ(found.mean, 2.0);
  EXPECT_EQ(found.rmse, std::sqrt(50.0 / 6));
  EXPECT_EQ(compare(flat(2, 2, 3, 255), flat(2, 2, 3, 0))->psnr, 0.0);
  EXPECT_NEAR(compare(flat(2, 2, 3, 51), flat(2, 2, 3, 0))->psnr, 13.979400086720377, 1e-14);
}

TEST(Compare, RefusesPicturesOfAnotherLayout) {
  const Image image = flat(4, 3, 3, 0);
  for (const Image& other : {flat(3, 4, 3, 0), flat(4, 3, 4, 0), flat(5, 3, 3, 0)}) {
    const auto refused = compare(image, other);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().front().trouble, Trouble::invalid);
    EXPECT_NE(refused.error().front().message.find("4 x 3 RGB against"), std::string::npos);
  }
}

TEST(DifferenceImage, ShowsEachChannelSixteenfold) {
  const Image expected = flat(3, 1, 3, 100);
  Image actual = expected;
  actual.at(0, 0)[1] = 103;
  actual.at(1, 0)[2] = 84;
  const Image shown = difference_image(actual, expected);
  EXPECT_EQ(shown.pixels, (std::vector<std::uint8_t>{0, 48, 0, 0, 0, 255, 0, 0, 0}));
}

TEST(DifferenceImage, ShowsADifferenceInAlphaAlone) {
  const Image expected = flat(1, 1, 4, 100);
  Image actual = expected;
  actual.pixels[3] = 99;
  EXPECT_EQ(difference_image(actual, expected).pixels, (std::vector<std::uint8_t>{16, 16, 16}));
}

LinearImage light(std::vector<float> pixels) {
  return {static_cast<int>(pixels.size() / 3), 1, std::move(pixels)};
}

TEST(Compare, LightIsComparedInItsOwnNumbersBeyondWhatIsShown) {
  const LinearImage expected = light({8, 2, 1e-6F, 0, 0, 0}),
                    actual = light({5, 2, 3e-6F, 0, 0, 0});
  const Difference found = compare(actual, expected).value();
  EXPECT_EQ(found.pixels, 1U);
  EXPECT_EQ(found.of, 2U);
  EXPECT_EQ(found.worst, 3);
  EXPECT_EQ(found.actual, 5);
  EXPECT_EQ(found.expected, 8);
  EXPECT_NEAR(found.mean, 0.5, 1e-6);
  EXPECT_NEAR(found.rmse, std::sqrt(9.0 / 6), 1e-6);
  EXPECT_NEAR(found.psnr, 10 * std::log10(64 / 1.5), 1e-6);  // of the brightest light
  EXPECT_FALSE(compare(actual, light({0, 0, 0})));
}

TEST(Compare, OfLightNoNumberIsAnInfiniteDifferenceFromAllButItself) {
  const float none = std::numeric_limits<float>::quiet_NaN();
  const LinearImage holes = light({none, 1, 1});
  EXPECT_EQ(compare(holes, holes)->pixels, 0U);
  const Difference found = compare(light({none, 1, 2}), holes).value();
  EXPECT_EQ(found.worst, 1);
  const Difference hole = compare(light({1, 1, 1}), holes).value();
  EXPECT_EQ(hole.worst, std::numeric_limits<double>::infinity());
  EXPECT_EQ(hole.rmse, std::numeric_limits<double>::infinity());
  EXPECT_EQ(hole.channel, 0);
}

TEST(DifferenceImage, OfLightIsTheSameInAnyUnit) {
  for (const float unit : {1e-6F, 1.0F, 1e6F}) {
    const LinearImage expected = light({unit, unit, unit, unit, unit, unit});
    LinearImage actual = expected;
    actual.pixels[1] += unit / 16, actual.pixels[3] += unit / 64;
    const Image shown = difference_image(actual, expected);
    EXPECT_EQ(shown.pixels, (std::vector<std::uint8_t>{0, 255, 0, 137, 0, 0})) << unit;
  }
}

TEST(Metrics, AreRegisteredByName) {
  std::vector<std::string> names;
  for (const Metric* metric : metrics()) names.emplace_back(metric->name);
  EXPECT_EQ(names, (std::vector<std::string>{"max", "mean", "psnr", "rmse"}));
}

TEST(Metrics, AreZeroOrInfiniteOnEqualPicturesAndOnNoOthers) {
  const Image image = noise(8, 8, 3);
  Image other = image;
  other.pixels[77] = static_cast<std::uint8_t>(other.pixels[77] ^ 1);
  for (const Metric* metric : metrics()) {
    const double equal = metric->value(image, image), different = metric->value(image, other);
    EXPECT_TRUE(equal == 0 || std::isinf(equal)) << metric->name;
    EXPECT_TRUE(different > 0 && std::isfinite(different)) << metric->name;
    const LinearImage one = light({1, 2, 3});
    EXPECT_EQ(metric->of_light(one, one), equal) << metric->name;
    EXPECT_TRUE(std::isfinite(metric->of_light(light({1, 2, 3.5F}), one))) << metric->name;
  }
}

}  // namespace
}  // namespace flatray
