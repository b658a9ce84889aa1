// What <flatray/picture.h> gives; and all public objects asked by two threads at once.
#include <gtest/gtest.h>

#include <thread>

#include "anim/timeline.h"
#include "flatray/collide.h"
#include "flatray/picture.h"
#include "flatray/transport.h"
#include "image/png.h"
#include "render/frame.h"
#include "scene/load.h"

namespace flatray {
namespace {

using Doubles = std::vector<double>;

constexpr const char* kScene = R"(flatray = 1
frames = 5
film = { size = [60, 40], world = [[0, 0], [60, 40]], background = "#204060" }
[[entity]]
name = "slider"
shape = { box = { min = [1.3, 2.6], max = [20.1, 30.9] } }
velocity = [60, 12]
fill = "#ff8000"
)";

TEST(PublicPicture, PixelsAreThoseOfTheModule) {
  const auto loaded = load_scene_text("s.toml", kScene);
  ASSERT_TRUE(loaded);
  const Timeline timeline(loaded->scene, loaded->scene.seed, 4);
  api::Picture picture;
  for (const unsigned frame : {1U, 4U}) {
    const auto list = draw_list(make_plan(loaded->scene, false), timeline, frame);
    const Image wanted = render_image(*list, {});
    ASSERT_TRUE(picture.draw("s.toml", kScene, frame, 2)) << picture.messages();
    EXPECT_EQ(picture.messages(), "");
    EXPECT_EQ(picture.width(), 60);
    EXPECT_EQ(picture.height(), 40);
    EXPECT_EQ(picture.channels(), 3);
    EXPECT_TRUE(std::equal(wanted.pixels.begin(), wanted.pixels.end(), picture.pixels().begin(),
                           picture.pixels().end()));
    const auto file = encode_png(wanted);
    const auto png = std::as_bytes(picture.png());
    EXPECT_TRUE(std::equal(file.begin(), file.end(), png.begin(), png.end()));
  }
}

TEST(PublicPicture, EveryMistakeIsToldWithItsPlaceAndNoPictureIsLeft) {
  api::Picture picture;
  EXPECT_EQ(picture.pixels().size(), 0U);
  EXPECT_EQ(picture.png().size(), 0U);
  EXPECT_EQ(picture.messages(), "");
  ASSERT_TRUE(picture.draw("s.toml", kScene));
  EXPECT_FALSE(picture.draw("s.toml", "flatray = 1\nfilm = { sise = [9, 9] }\nfrms = 3\n"));
  const std::string_view told = picture.messages();
  EXPECT_NE(told.find("s.toml:2:10: error: "), std::string_view::npos) << told;
  EXPECT_NE(told.find("s.toml:3:1: error: "), std::string_view::npos) << told;
  EXPECT_EQ(picture.width(), 0);
  EXPECT_TRUE(picture.pixels().empty());
  EXPECT_FALSE(picture.draw("s.toml", kScene, 0));
  EXPECT_NE(picture.messages().find("there is no frame 0"), std::string_view::npos);
  EXPECT_FALSE(picture.draw("s.unknown", kScene));
  ASSERT_TRUE(picture.draw("s.toml", kScene));
  const api::Picture taken = std::move(picture);
  EXPECT_EQ(taken.width(), 60);
  EXPECT_EQ(picture.width(), 0);  // NOLINT(bugprone-use-after-move)
  EXPECT_TRUE(picture.draw("s.toml", kScene));
}

// Calls `ask` on two threads at once, some times each, and compares with what it gives alone.
template <class Ask>
void expect_same_on_two_threads(const Ask& ask) {
  const auto alone = ask();
  bool same[2] = {true, true};
  const auto work = [&](bool& all_same) {
    for (int round = 0; round < 5; ++round) all_same = ask() == alone && all_same;
  };
  std::thread other(work, std::ref(same[0]));
  work(same[1]);
  other.join();
  EXPECT_TRUE(same[0] && same[1]);
}

TEST(PublicObjects, TwoThreadsMayAskOneAtOnce) {
  api::Walls walls;
  const Doubles x = {0, 8, 8, 0}, y = {0, 0, 8, 8};
  ASSERT_TRUE(walls.add_ring(x, y));
  ASSERT_TRUE(walls.add_circles(Doubles{6}, Doubles{4}, Doubles{1}));
  const api::RayTracer tracer(walls);
  const api::Room room(walls);
  Doubles ox, oy, dx, dy;
  for (int i = 0; i < 500; ++i) {
    ox.push_back(1 + i % 4), oy.push_back(1 + i % 7);
    dx.push_back(i % 11 - 5), dy.push_back(i % 13 - 5.5);
  }
  const api::Rays rays{ox, oy, dx, dy};
  expect_same_on_two_threads([&] {
    std::vector<api::Hit> hits(rays.size()), all;
    std::vector<std::size_t> ends;
    EXPECT_TRUE(tracer.nearest(rays, hits) && tracer.all(rays, all, ends));
    hits.insert(hits.end(), all.begin(), all.end());
    return hits;
  });
  expect_same_on_two_threads([&] {
    std::vector<std::uint8_t> met(rays.size());
    EXPECT_TRUE(tracer.any(rays, Doubles(rays.size(), 0.75), met));
    return met;
  });
  expect_same_on_two_threads([&] {
    std::vector<api::Orbit> orbits;
    std::vector<api::Bounce> bounces;
    EXPECT_TRUE(room.orbits(rays, 20, orbits, bounces));
    return bounces;
  });
  expect_same_on_two_threads([&] {
    std::vector<api::Interval> parts(rays.size());
    EXPECT_TRUE(api::clip_convex(rays, x, y, api::kRay, parts));
    return parts;
  });

  api::Bodies bodies;
  ASSERT_TRUE(bodies.add_polygon(x, y));
  ASSERT_TRUE(bodies.add_discs(Doubles{20, 30}, Doubles{4, 5}, Doubles{0, 2}));
  std::vector<api::MovingPair> pairs;
  for (std::uint32_t i = 0; i < 300; ++i)
    pairs.push_back({0, 1 + i % 2, 1.0 + i, 0, 0, 0.125 * (i % 5)});
  expect_same_on_two_threads([&] {
    std::vector<api::Contact> contacts(pairs.size());
    EXPECT_TRUE(bodies.contacts(pairs, api::kRay, contacts));
    return contacts;
  });
}

TEST(PublicObjects, PicturesAreDrawnOnTwoThreadsAtOnce) {
  expect_same_on_two_threads([] {
    api::Picture picture;
    EXPECT_TRUE(picture.draw("s.toml", kScene, 3));
    return std::vector<std::uint8_t>(picture.pixels().begin(), picture.pixels().end());
  });
}

}  // namespace
}  // namespace flatray
