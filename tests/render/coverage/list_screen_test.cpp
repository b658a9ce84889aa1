// The paper's list: "SPIDER MAN" at (200, 200) appears at that pixel of the screen.
// needs: shapes/box formats/list formats/toml
#include <gtest/gtest.h>

#include "support/pictures.h"

namespace flatray {
namespace {

Image screen(const std::string& list, const std::vector<Override>& overrides = {}) {
  const Result<LoadedScene> loaded = load_scene_text("objects.list", list, overrides);
  if (!loaded) {
    ADD_FAILURE() << format(loaded.error());
    return {};
  }
  return picture(loaded->scene);
}

// The colour of fills within [left, left + 64) across and [bottom, bottom + 128) up, in full; white elsewhere.
void expect_block(const Image& seen, int left, int bottom) {
  std::size_t filled = 0;
  for (int y = 0; y < seen.height; ++y)
    for (int x = 0; x < seen.width; ++x) {
      const int up = seen.height - 1 - y;
      const bool inside = x >= left && x < left + 64 && up >= bottom && up < bottom + 128;
      ASSERT_EQ(seen.at(x, y)[0], inside ? 0x33 : 255) << x << "," << up;
      filled += inside ? 1U : 0U;
    }
  EXPECT_GT(filled, 0U);
}

TEST(ListOnScreen, AnObjectIsAtItsPixel) {
  const Image seen = screen("{ SPIDER MAN, 200,200}");
  EXPECT_EQ(seen.width, 640);
  EXPECT_EQ(seen.height, 360);
  expect_block(seen, 200, 200);
  expect_block(screen("A, 0, 0"), 0, 0);
  expect_block(screen("A, -60, -1"), -60, -1);
}

TEST(ListOnScreen, WhatIsBesideTheScreenIsNotSeen) {
  const Image beside = screen("{ SPIDER MAN, 5000, -70 }");
  EXPECT_FALSE(has_content(beside));
  EXPECT_NE(beside, screen("{ SPIDER MAN, 200, 200 }"));
}

TEST(ListOnScreen, OtherObjectsAndOtherSizesMoveNothing) {
  const Image one = screen("A, 200, 200"), two = screen("A, 200, 200\nB, 5000, -70");
  EXPECT_EQ(one, two);
  expect_block(screen("A, 200, 200", {{"film.size", "[300, 500]"}}), 200, 200);
}

TEST(ListOnScreen, AnIncludedListIsOnTheScreenOfTheSceneThatIncludesIt) {
  EXPECT_EQ(picture(scene_of(R"(flatray = 1
film = { size = [300, 500], world = "pixels" }
[[entity]]
shape = { box = { min = [0, 0], max = [64, 128] } }
at = [200, 200]
)")),
            screen("A, 200, 200", {{"film.size", "[300, 500]"}}));
}

TEST(ListOnScreen, AWordThatIsNoWindowIsRefused) {
  const auto got = load_scene_text("a.toml", "flatray = 1\nfilm = { world = \"pixel\" }\n");
  ASSERT_FALSE(got);
  EXPECT_NE(format(got.error()).find("a.toml:2:18: error: "), std::string::npos)
      << format(got.error());
  EXPECT_NE(format(got.error()).find("pixels"), std::string::npos);
}

}  // namespace
}  // namespace flatray
