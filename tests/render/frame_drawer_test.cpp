#include <gtest/gtest.h>

#include "render/coverage_families.h"
#include "render/frame.h"
#include "support/pictures.h"

namespace flatray {
namespace {

using coverage_check::box_path;
using coverage_check::Draws;

// Forty boxes and discs that stay, and one of each that moves, over two films and colours.
DrawList moving_list(int frame) {
  DrawList list{200, 150, {1, 1, 1, 1}, Coverage::area, {}};
  for (std::uint64_t item = 0; item < 40; ++item) {
    Draws draws(3, item);
    const double x = 200 * draws.unit(), y = 150 * draws.unit(), size = 20 * draws.unit();
    const float alpha = item % 3 ? 1.0F : 0.4F, shade = static_cast<float>(draws.unit());
    if (item % 2)
      list.items.push_back({box_path(x, y, x + size, y + size / 2), {shade, 0, 1, alpha}});
    else
      list.items.push_back({FillRing{{x, y}, size}, {0, shade, 0.5F, alpha}});
  }
  list.items.insert(list.items.begin() + 11,
                    {box_path(3 * frame, 40.25, 3 * frame + 7.5, 50), {1, 0, 0, 0.7F}});
  list.items.push_back({FillRing{{60, 20 + 2.0 * frame}, 9}, {0, 0, 1, 1}});
  return list;
}

TEST(FrameDrawer, PicturesDoNotDependOnTheFramesBefore) {
  for (const PixelBox crop : {PixelBox{0, 0, 200, 150}, PixelBox{31, 17, 90, 101}}) {
    FrameDrawer<Image> drawer({crop, 1});
    for (const int frame : {0, 1, 2, 2, 30, 3, 0}) {
      const DrawList list = moving_list(frame);
      EXPECT_EQ(drawer.draw(list), render_image(list, {crop, 1})) << frame;
    }
  }
}

// Of a list with one item that moves, how many pixels of the bands drawn were kept in each of six
// frames, all of them as if drawn alone.
template <class Move>
std::vector<std::uint64_t> kept_pixels(DrawList list, const Move& move, unsigned threads = 1) {
  FrameOptions options;
  options.threads = threads;
  FrameDrawer<Image> drawer(options);
  FrameDrawer<LinearImage> light(options);
  std::vector<std::uint64_t> counts;
  for (int frame = 0; frame < 6; ++frame) {
    move(frame, list);
    const std::uint64_t before = drawer.counts().kept_pixels;
    EXPECT_EQ(drawer.draw(list), render_image(list, {})) << frame;
    EXPECT_EQ(light.draw(list).pixels, render_linear(list, {}).pixels) << frame;
    counts.push_back(drawer.counts().kept_pixels - before);
  }
  return counts;
}

// Forty discs and boxes over a film of one band, veils among them, below one that moves.
DrawList floor_list(Coverage coverage = Coverage::area, float alpha = 0.4F) {
  DrawList list{128, 64, {0.2F, 0.3F, 0.4F, 1}, coverage, {}};
  for (std::uint64_t item = 0; item < 40; ++item) {
    Draws draws(5, item);
    const double x = 128 * draws.unit(), y = 64 * draws.unit(), size = 2 + 20 * draws.unit();
    const LinearColour colour{static_cast<float>(draws.unit()), 0.5F, 1, item % 3 ? 1.0F : alpha};
    if (item % 2)
      list.items.push_back({box_path(x, y, x + size, y + size / 2), colour});
    else
      list.items.push_back({FillRing{{x, y}, size}, colour});
  }
  list.items.push_back({});
  return list;
}

void move_last(int frame, DrawList& list) {
  list.items.back() = {FillRing{{20.0 + 9 * frame, 30.25}, 12.5}, {1, 0, 0, 0.75F}};
}

// From 7 left of where the disc was, and a pixel of margin, to as far right of where it is: of 128
// columns, 64 rows each.
TEST(FrameDrawer, WhatLiesBesideWhatMovesIsKept) {
  using Counts = std::vector<std::uint64_t>;
  constexpr std::uint64_t kBeside = 64 * (128 - (9 + 2 * 14));
  for (const unsigned threads : {1U, 3U}) {
    const Counts counts = kept_pixels(floor_list(), &move_last, threads);
    EXPECT_EQ(counts[0], 0U);
    for (std::size_t i = 1; i < counts.size(); ++i)
      EXPECT_NEAR(static_cast<double>(counts[i]), static_cast<double>(kBeside), 64 * 8) << i;
  }
  for (const Coverage coverage : {Coverage::rows, Coverage::centre}) {
    const Counts counts = kept_pixels(floor_list(coverage), &move_last);
    EXPECT_EQ(counts, kept_pixels(floor_list(), &move_last));
  }
}

// Its own columns are 45 to 54; a pixel on either side is for rounding.
TEST(FrameDrawer, ADiscThatTakesAnotherColourIsDrawnInItsColumnsAndOneOnEitherSide) {
  DrawList list{128, 64, {1, 1, 1, 1}, Coverage::area, {}};
  list.items.push_back({FillRing{{50, 30}, 5}, {1, 0, 0, 1}});
  const auto change = [](int frame, DrawList& drawn) {
    drawn.items[0].colour.b = frame % 2 == 0 ? 0.0F : 1.0F;
  };
  const std::vector<std::uint64_t> kept = kept_pixels(list, change);
  for (std::size_t frame = 1; frame < kept.size(); ++frame)
    EXPECT_EQ(kept[frame], (128U - 12) * 64) << frame;
}

TEST(FrameDrawer, WhatMovesLowestLeavesWhatLiesAboveItBeside) {
  const auto lowest = [](int frame, DrawList& list) {
    list.items.front() = {FillRing{{20.0 + 9 * frame, 30.25}, 12.5}, {1, 0, 0, 1}};
    list.items.back() = {box_path(1, 1, 9, 9), {0, 0, 0, 1}};
  };
  EXPECT_GT(kept_pixels(floor_list(), lowest)[3], 0U);
}

// What comes and goes moves all after it in the list, and nothing else in the picture. Its right edge, on the
// border of two columns, is in both.
TEST(FrameDrawer, WhatComesAndGoesLeavesWhatLiesBeside) {
  const auto blink = [](int frame, DrawList& list) {
    if (frame % 2 == 1)
      list.items.insert(list.items.begin() + 5, {box_path(10, 10, 20, 20), {1, 0, 0, 0.5F}});
    else if (frame > 0)
      list.items.erase(list.items.begin() + 5);
  };
  DrawList list = floor_list();
  list.items.back() = {box_path(1, 1, 9, 9), {0, 0, 0, 1}};
  for (std::size_t i = 1; i < 6; ++i) EXPECT_EQ(kept_pixels(list, blink)[i], 64U * (128 - 11)) << i;
}

// A layer of which a part moves, and a gradient below it.
TEST(FrameDrawer, LayersAndGradientsAreAsDrawnAlone) {
  DrawList list = floor_list();
  FilmGradient gradient;
  gradient.axis = {1.0 / 128, 0};
  gradient.stops = {{0, {1, 0, 0, 1}}, {1, {0, 0, 1, 1}}};
  list.items[5].gradient = gradient;
  for (std::size_t i = 36; i < 40; ++i) list.items[i].layer = 1, list.items[i].opacity = 0.5F;
  const auto move = [](int frame, DrawList& moved) {
    move_last(frame, moved);
    moved.items.back().layer = 1, moved.items.back().opacity = 0.5F;
  };
  EXPECT_GT(kept_pixels(list, move)[3], 0U);
}

TEST(FrameDrawer, SaysWhichRowsMayHaveChanged) {
  FrameDrawer<Image> drawer({PixelBox{0, 30, 1000, 600}, 1});
  DrawList list{1000, 640, {1, 1, 1, 1}, Coverage::area, {}};
  list.items.push_back({box_path(100, 100, 110, 110), {1, 0, 0, 1}});
  drawer.draw(list);
  EXPECT_TRUE(drawer.changed(0, 1));
  std::get<FillPath>(list.items[0].region) = box_path(101, 100, 111, 110);
  drawer.draw(list);
  EXPECT_TRUE(drawer.changed(64, 96)) << "rows 94 to 126 of the film";
  EXPECT_FALSE(drawer.changed(0, 64));
  EXPECT_FALSE(drawer.changed(96, 600));
}

TEST(FrameDrawer, WhatMovesAloneIsDrawnAgain) {
  FrameDrawer<Image> drawer({});
  DrawList list{1000, 640, {1, 1, 1, 1}, Coverage::area, {}};
  list.items.push_back({box_path(100, 100, 110, 110), {1, 0, 0, 1}});
  list.items.push_back({box_path(0, 0, 1000, 20), {0, 1, 0, 1}});
  drawer.draw(list);
  EXPECT_EQ(drawer.counts().bands, 20U) << "32 rows each";
  EXPECT_TRUE(drawer.changed());
  std::get<FillPath>(list.items[0].region) = box_path(101, 100, 111, 110);
  drawer.draw(list);
  EXPECT_EQ(drawer.counts().bands, 21U);
  EXPECT_EQ(drawer.counts().kept_bands, 19U);
  EXPECT_TRUE(drawer.changed());
  drawer.draw(list);
  EXPECT_EQ(drawer.counts().bands, 21U);
  EXPECT_FALSE(drawer.changed());
}

TEST(FrameDrawer, AnotherBackgroundSizeOrCoverageDrawsAll) {
  FrameDrawer<Image> drawer({});
  DrawList list = moving_list(0);
  const auto drawn_as_alone = [&] { return drawer.draw(list) == render_image(list, {}); };
  EXPECT_TRUE(drawn_as_alone());
  list.coverage = Coverage::centre;
  EXPECT_TRUE(drawn_as_alone());
  list.background = {0, 0, 0, 0};
  EXPECT_TRUE(drawn_as_alone());
  list.width = 77;
  EXPECT_TRUE(drawn_as_alone());
}

TEST(FrameDrawer, AnOpaqueItemOverABandHidesThoseBelowIt) {
  DrawList list{1000, 64, {1, 1, 1, 1}, Coverage::area, {}};
  for (int i = 0; i < 10; ++i)
    list.items.push_back({FillRing{{100.0 * i, 16}, 12}, {0.1F, 0.2F, 0.3F, 1}});
  list.items.push_back({box_path(-1, -1, 1001, 32), {0, 0.5F, 0, 1}});  // the first band, no more
  list.items.push_back({FillRing{{500, 30}, 20}, {1, 0, 0, 0.5F}});
  const auto hidden = [&list] {
    FrameDrawer<Image> drawer({});
    FrameDrawer<Image> all({std::nullopt, 1, true});
    EXPECT_EQ(drawer.draw(list), all.draw(list));
    EXPECT_EQ(all.counts().hidden_items, 0U);
    return drawer.counts().hidden_items;
  };
  EXPECT_EQ(hidden(), 10U);
  list.items[10].colour.a = 0.999F;
  EXPECT_EQ(hidden(), 0U) << "what is not opaque hides nothing";
  list.items[10] = {box_path(-1, 0x1p-20, 1001, 32), {0, 0.5F, 0, 1}};
  EXPECT_EQ(hidden(), 0U) << "a millionth of a pixel is open";
  list.coverage = Coverage::centre;
  EXPECT_EQ(hidden(), 10U) << "but no centre is";
}

// Found by a reader: what waits to be blended grew with every veil.
TEST(FrameDrawer, VeilsOverVeilsAreBlendedInOrder) {
  DrawList list{120, 90, {1, 1, 1, 1}, Coverage::area, {}};
  for (int i = 0; i < 300; ++i)
    list.items.push_back(
        {box_path(-1, -1, 121 - i % 7, 91), {0.1F, 0.003F * static_cast<float>(i), 0.5F, 0.02F}});
  EXPECT_EQ(FrameDrawer<Image>({}).draw(list),
            FrameDrawer<Image>({std::nullopt, 1, true}).draw(list));
}

TEST(FrameDrawer, AStopLeavesBandsUndrawnAndSaysSo) {
  const Scene scene = scene_of("flatray = 1\nfilm = { size = [64, 64] }\n");
  const auto list = draw_list(make_plan(scene, false), Timeline(scene, 0, 1), 1);
  FrameOptions options;
  options.stop = [] { return true; };
  FrameDrawer<Image> stopped(options);
  stopped.draw(*list);
  EXPECT_FALSE(stopped.whole());
  EXPECT_EQ(stopped.counts().bands, 0u);
  options.stop = [] { return false; };
  FrameDrawer<Image> drawn(options);
  drawn.draw(*list);
  EXPECT_TRUE(drawn.whole());
}

// Frames 1, 2, 3 show 0, 0.5, 1: nothing, what a fixed opacity shows, and what none shows.
TEST(FrameDrawer, OpacityThatIsACurveIsThatOfItsTime) {
  const auto scene = [](const std::string& opacity) {
    return scene_of(
        "flatray = 1\nframes = 4\nfps = 2\nfilm = { size = [64, 64], world = [[0, 0], [9, 9]] }\n"
        "[[entity]]\nshape = { box = { min = [-3, -3], max = [3, 3] } }\nat = [4, 4]\nfill = "
        "\"#336699\"\n"
        "stroke = { width = 1 }\n" +
        opacity + "\n");
  };
  const Scene fading = scene("opacity = { keys = [[0, 0], [1, 1]] }");
  const Image half = picture(fading, 2), full = picture(fading, 3);
  EXPECT_FALSE(has_content(picture(fading, 1)));
  EXPECT_EQ(half.pixels, picture(scene("opacity = 0.5")).pixels);
  EXPECT_EQ(full.pixels, picture(scene("")).pixels);
  EXPECT_NE(half.pixels, full.pixels);

  const RenderPlan plan = make_plan(fading, false);
  EXPECT_FALSE(plan.still);
  const Timeline timeline(fading, 0, 4);
  FrameDrawer<Image> carried(FrameOptions{});
  FrameOptions every;
  every.keep_all = true;
  for (unsigned frame = 1; frame <= 4; ++frame)
    EXPECT_EQ(carried.draw(*draw_list(plan, timeline, frame)).pixels,
              picture(fading, frame, every).pixels)
        << frame;
  EXPECT_FALSE(carried.changed());  // the last key's value stays
}

// One scene with what `entity` says of a box of 6 x 6 at the middle of 9 x 9.
Scene box_scene(const std::string& entity) {
  return scene_of(
      "flatray = 1\nframes = 4\nfps = 2\nfilm = { size = [64, 64], world = [[0, 0], [9, 9]] }\n"
      "[[entity]]\nname = \"box\"\n" +
      entity + "\n");
}

// Every frame alone, and carried from frame to frame.
void expect_the_same_carried(const Scene& scene) {
  const RenderPlan plan = make_plan(scene, false);
  EXPECT_FALSE(plan.still);
  const Timeline timeline(scene, 0, 4);
  FrameDrawer<Image> carried(FrameOptions{});
  for (unsigned frame = 1; frame <= 4; ++frame)
    EXPECT_EQ(carried.draw(*draw_list(plan, timeline, frame)).pixels, picture(scene, frame).pixels)
        << frame;
}

// Frame 2 is at 0.5 s, half way between the keys.
TEST(FrameDrawer, ShapesThatChangeAreDrawnAsWrittenForTheirTime) {
  const std::string fill = "fill = \"#336699\"\nstroke = { width = 0.5 }\nat = [1, 1]\n";
  const Scene growing = box_scene(
      fill + "shape = { box = { min = [0, 0], max = { keys = [[0, [1, 2]], [1, [6, 5]]] } } }");
  EXPECT_EQ(
      picture(growing, 2).pixels,
      picture(box_scene(fill + "shape = { box = { min = [0, 0], max = [3.5, 3.5] } }")).pixels);
  expect_the_same_carried(growing);
  const Scene born =
      box_scene("shape = { ngon = { sides = 6, radius = { keys = [[0, 0], [1, 3]] } } }");
  EXPECT_FALSE(has_content(picture(born, 1)));
  EXPECT_TRUE(has_content(picture(born, 2)));
}

TEST(FrameDrawer, GroupsThatGrowAreDrawnAsThoseOfTheirSize) {
  const auto grown = [](const std::string& scale) {
    return box_scene(
        "group = \"g\"\nshape = { ellipse = { radii = [2, 2] } }\nat = [2, 2]\nstroke = { width = "
        "0.5 "
        "}\n[[group]]\nname = \"g\"\nscale = " +
        scale);
  };
  EXPECT_EQ(picture(grown("{ keys = [[0, 0.5], [1, 2]] }"), 2).pixels,
            picture(grown("1.25")).pixels);
  expect_the_same_carried(grown("{ keys = [[0, 0], [1, 2]] }"));
}

// Half the light of white is 188 of 255, not 128; between clear red and opaque blue lies a blue that
// is half there, as in a gradient.
TEST(FrameDrawer, ColoursThatChangeAreBlendedAsPremultipliedLight) {
  const std::string shape = "shape = { box = { min = [1, 1], max = [7, 7] } }\n";
  const Scene grey = box_scene(shape + "fill = { keys = [[0, \"#000000\"], [1, \"#ffffff\"]] }");
  EXPECT_EQ(picture(grey, 2).at(30, 30)[0], 188);
  EXPECT_EQ(picture(grey, 1).at(30, 30)[0], 0);
  EXPECT_EQ(picture(grey, 3).at(30, 30)[0], 255);
  expect_the_same_carried(grey);
  const Scene clear = box_scene(shape + "fill = { keys = [[0, \"#ff000000\"], [1, \"#0000ff\"]] }");
  const Image half = picture(clear, 2);
  EXPECT_EQ(half.at(30, 30)[0], 188);  // what half of the white below leaves
  EXPECT_EQ(half.at(30, 30)[2], 255);
  const Scene line = box_scene(
      shape + "stroke = { width = 1, colour = { keys = [[0, \"#112233\"], [1, \"#445566\"]] } }");
  const Scene same = box_scene(shape + "stroke = { width = 1, colour = \"#445566\" }");
  EXPECT_EQ(picture(line, 3).pixels, picture(same).pixels);
}

}  // namespace
}  // namespace flatray
