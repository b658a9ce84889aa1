#include <gtest/gtest.h>

#include "render/coverage_families.h"
#include "render/frame.h"

namespace flatray {
namespace {

// Light, and pictures with a gradient, which are drawn as light: what an opaque box covers is left out
// there, too, and the picture is the same.
TEST(FrameDrawer, WhatIsHiddenIsNotDrawnAsLightEither) {
  DrawList list{1000, 64, {1, 1, 1, 1}, Coverage::area, {}};
  for (int i = 0; i < 10; ++i)
    list.items.push_back({FillRing{{100.0 * i, 16}, 12}, {0.1F, 0.2F, 0.3F, 1}});
  list.items.push_back(
      {coverage_check::box_path(-1, -1, 1001, 32), {0, 0.5F, 0, 1}});  // the first band, no more
  FilmGradient gradient;
  gradient.axis = {0.001, 0};
  gradient.stops = {{0, {1, 0, 0, 0.5F}}, {1, {0, 0, 1, 0.5F}}};
  list.items.push_back({FillRing{{500, 30}, 20}, {1, 0, 0, 0.5F}, gradient});
  FrameDrawer<LinearImage> light({}), all_light({std::nullopt, 1, true});
  EXPECT_EQ(light.draw(list).pixels, all_light.draw(list).pixels);
  EXPECT_EQ(light.counts().hidden_items, 10U);
  EXPECT_EQ(all_light.counts().hidden_items, 0U);
  FrameDrawer<Image> drawer({}), all({std::nullopt, 1, true});
  EXPECT_EQ(drawer.draw(list), all.draw(list));
  EXPECT_EQ(drawer.counts().hidden_items, 10U);
  EXPECT_EQ(all.counts().hidden_items, 0U);
}

}  // namespace
}  // namespace flatray
