#include "anim/camera.h"

#include <gtest/gtest.h>

#include "anim/world.h"
#include "scenes.h"

namespace flatray {
namespace {

using namespace flatray::testing;

Bounds window(const Scene& scene, unsigned frame = 1) {
  return at(Timeline(scene, scene.seed, frame), frame).window;
}

void expect_window(const Bounds& window, const Vec2& low, const Vec2& high) {
  EXPECT_EQ(window.low, low);
  EXPECT_EQ(window.high, high);
}

TEST(Camera, TheWorldWindowIsGrownAboutItsCentreToTheFilmsAspect) {
  Scene scene = small_scene();
  expect_window(window(scene), {0, 0}, {20, 10});
  scene.film.world = Bounds{{0, 0}, {10, 10}};
  expect_window(window(scene), {-5, 0}, {15, 10});
  scene.film.world = Bounds{{0, 0}, {40, 10}};
  expect_window(window(scene), {0, -5}, {40, 15});
}

TEST(Camera, AWindowThatFitsKeepsItsBits) {
  Scene scene = small_scene();
  const Bounds odd{{0.1, 0.3}, {0.1 + 0x1p-3, 0.3 + 0x1p-4}};
  scene.film.world = odd;
  expect_window(window(scene), odd.low, odd.high);
}

TEST(Camera, HeightAndPlaceOfTheCameraComeFirst) {
  Scene scene = small_scene();
  scene.camera.at = MovingPoint{{100, 50}, {}, {}};
  expect_window(window(scene), {90, 45}, {110, 55});
  scene.camera.height = {4, {}};
  expect_window(window(scene), {96, 48}, {104, 52});
  scene.camera.at.reset();
  expect_window(window(scene), {6, 3}, {14, 7});
}

TEST(Camera, ZoomDividesTheHeightAndKeepsThePlaceToTheLastDigit) {
  Scene zoomed = small_scene();
  zoomed.camera.at = MovingPoint{{0.1, 0.2}, {}, {}};
  Scene near = zoomed;
  for (const double zoom : {1.0, 0x1p40, 0x1p50, 0x1p60}) {
    zoomed.camera.height = {10, {}};
    zoomed.camera.zoom = {zoom, {}};
    near.camera.height = {10 / zoom, {}};
    expect_window(window(zoomed), window(near).low, window(near).high);
  }
}

// Whatever else there is, and whatever world, however far away.
TEST(Camera, FollowingIsNotRoundedByFarContent) {
  Scene scene = small_scene();
  scene.camera.follow = add_box(scene, {0, 0}, {0.5, 0.5});
  scene.camera.height = {1.3, {}};
  const Bounds alone = window(scene);
  for (const double far : {1e13, 1e15, 1e18}) {
    Scene wide = scene;
    add_box(wide, {far, 0}, {1, 1});
    expect_window(window(wide), alone.low, alone.high);
    wide.film.world = Bounds{{far, 0}, {2 * far, far}};
    expect_window(window(wide), alone.low, alone.high);
  }
}

TEST(Camera, TheContentIsOfCurvesAndNotOfTheirControlPoints) {
  Scene scene = small_scene();
  scene.film.world.reset();
  add_box(scene, {0, 0}, {7, 0});
  scene.shapes[0] = {};
  scene.shapes[0].beziers = {Bezier({-100, 100}, {0, -100}, {100, 100})};  // from y = 0 on
  EXPECT_EQ(window(scene).low, Vec2(-110, -5));
  EXPECT_EQ(window(scene).high, Vec2(110, 105));
}

TEST(Camera, WithoutAWindowTheContentOfTheFirstFrameIsShownWithFivePercent) {
  Scene scene = small_scene();
  scene.film.world.reset();
  const std::uint32_t runner = add_box(scene, {0, 0}, {7, 0});
  scene.shapes[0] = box({0, 0}, {200, 100});
  EXPECT_EQ(window(scene).low, Vec2(-10, -5));
  EXPECT_EQ(window(scene, 9).high, Vec2(210, 105));  // it has moved, the window has not
  scene.entities[runner].stroke = Stroke{.width = 40, .colour = {}};
  EXPECT_LE(window(scene).low.x(), -20 - 12);
  scene.entities[runner].stroke->in_pixels = true;
  EXPECT_EQ(window(scene).low, Vec2(-10, -5));
}

TEST(Camera, EveryKindOfContentIsShown) {
  Scene scene = small_scene();
  scene.film.world.reset();
  Shape circle;
  circle.circles.push_back({{0, 0}, 2});
  Shape segment;
  segment.segments.push_back({{0, 0}, {1, -9}});
  Shape ring;
  ring.crossing_rings.push_back({{0, 0}, {30, 0}, {0, 1}});
  scene.shapes = {box({0, 0}, {20, 20}), circle, segment, ring};
  Entity entity;
  entity.shape = 2;
  scene.entities.push_back(entity);
  entity.shape = 3;
  scene.entities.push_back(entity);
  Chamber room;
  room.pillars.push_back({.name = "p",
                          .shape = 1,
                          .at = {-5, 5},
                          .fill = {},
                          .stroke = {},
                          .where = {},
                          .copy_of = {}});
  scene.chambers.push_back(room);
  RayPath ray;
  ray.at = {3, 40};
  scene.rays.push_back(ray);
  const Bounds content = Timeline(scene, 0, 1).content();
  expect_window(content, {-7, -9}, {30, 40});
}

TEST(StiffCases, E1EmptySceneHasAUnitWindow) {
  Scene scene = small_scene();
  scene.film.world.reset();
  expect_window(window(scene), {-0.5, 0}, {1.5, 1});
}

TEST(Camera, APointOfContentHasAWindowRoundIt) {
  Scene scene = small_scene();
  scene.film.world.reset();
  RayPath ray;
  for (const double place : {0.0, 3.0, 1e15, -1e300}) {
    ray.at = {place, 1};
    scene.rays = {ray};
    const Bounds shown = window(scene);
    EXPECT_LT(shown.low.x(), place);
    EXPECT_GT(shown.high.x(), place);
    EXPECT_LT(shown.low.y(), 1);
    EXPECT_GT(shown.high.y(), 1);
  }
}

TEST(Camera, FollowingKeepsTheRunnersPlaceOnTheFilm) {
  Scene scene = small_scene();
  scene.seed = 5;
  const std::uint32_t runner = add_box(scene, {4, 1}, {12, 0.5});
  scene.chains.push_back(runner_chain());
  scene.entities[runner].markov = MarkovUse{0, 0, std::nullopt, {}};
  scene.camera.follow = runner;
  scene.camera.offset = {2, 3};
  const Timeline timeline(scene, scene.seed, 40);
  for (unsigned k = 1; k <= 40; ++k) {
    const FrameState state = at(timeline, k);
    EXPECT_EQ(state.entities[runner].at - state.window.low, Vec2(10 - 2, 5 - 3));
    EXPECT_EQ(state.window.size(), Vec2(20, 10));
  }
}

TEST(Camera, ItsVelocityMovesTheWindowsOrigin) {
  Scene scene = small_scene();
  scene.camera.velocity = {3, -1};
  expect_window(window(scene, 5), {12, -4}, {32, 6});
}

// Everything that has a place, with dyadic coordinates, seen by a moving camera.
Scene dyadic_scene() {
  Scene scene = small_scene();
  scene.fps = 8;
  add_box(scene, {4.25, 1.5}, {1.75, -0.5});
  add_box(scene, {0.125, 7}, {0, 0});
  scene.entities[1].angle = 0x1.921fb54442d18p+0;
  scene.shapes.push_back(box({0, 0}, {20, 10}));
  Shape disc;
  disc.circles.push_back({{0.5, 0.5}, 1});
  scene.shapes.push_back(disc);
  Chamber room;
  room.shape = 2;
  room.pillars.push_back({.name = "p",
                          .shape = 3,
                          .at = {5, 5},
                          .fill = {},
                          .stroke = {},
                          .where = {},
                          .copy_of = {}});
  scene.chambers.push_back(room);
  scene.camera.velocity = {2.5, 0.75};
  return scene;
}

// The paper's Q = P + v: moving the origin and moving everything else are one picture.
TEST(Camera, MovingTheFrameOriginEqualsMovingEveryObjectBitForBit) {
  Scene origin = dyadic_scene(), objects = origin;
  objects.camera.motion = CameraMotion::objects;
  for (const bool follow : {false, true}) {
    if (follow) origin.camera.follow = objects.camera.follow = 0;
    const Timeline a(origin, 0, 100), b(objects, 0, 100);
    for (unsigned k = 1; k <= 100; ++k) {
      const FrameState moved = at(a, k), displaced = at(b, k);
      expect_window(displaced.window, at(a, 1).window.low, at(a, 1).window.high);
      const World here = build_world(origin, moved), there = build_world(objects, displaced);
      ASSERT_EQ(here.surfaces.size(), there.surfaces.size());
      for (std::size_t i = 0; i < here.surfaces.segments.size(); ++i) {
        const Segment &s = here.surfaces.segments[i], &t = there.surfaces.segments[i];
        EXPECT_EQ(s.a - moved.window.low, t.a - displaced.window.low);
        EXPECT_EQ(s.b - moved.window.low, t.b - displaced.window.low);
      }
      EXPECT_EQ(here.surfaces.arcs[0].curve.centre - moved.window.low,
                there.surfaces.arcs[0].curve.centre - displaced.window.low);
    }
  }
}

}  // namespace
}  // namespace flatray
