// needs: shapes/box shapes/circle shapes/polygon
#include "collide/scene_timeline.h"

#include <gtest/gtest.h>

#include "anim/moving_walls.h"
#include "base/check.h"
#include "support/pictures.h"

namespace flatray {
namespace {

Scene text_scene(const std::string& text, const std::string& head = "") {
  return scene_of("flatray = 1\nfps = 10\nframes = 41\n" + head + text);
}
std::string disc_entity(const std::string& more) {
  return "[[entity]]\nshape = { circle = { radius = 1 } }\n" + more + "\n";
}

Timeline timeline_of(const Scene& scene, unsigned last) {
  Result<Timeline> made = make_timeline(scene, scene.seed, last);
  FLATRAY_CHECK(made.has_value(), made ? "" : format(made.error()));
  return std::move(*made);
}

Image picture(const Timeline& timeline, unsigned frame) {
  return render_image(*draw_list(make_plan(timeline.scene(), false), timeline, frame), {});
}

const std::string kBounce = "collisions = { response = \"bounce\" }\n";

TEST(MakeTimeline, BodiesThatBounceAreWhereTheirEventsLeaveThem) {
  const Scene scene = text_scene(
      disc_entity("velocity = [1, 0]") + disc_entity("at = [6, 0]\nvelocity = [-1, 0]"), kBounce);
  const Timeline timeline = timeline_of(scene, 41);
  ASSERT_EQ(timeline.events().size(), 1U);
  for (unsigned frame = 1; frame <= 41; ++frame) {
    const double t = (frame - 1) / 10.0, gone = t < 2 ? t : 4 - t;
    const auto now = entity_states(timeline, frame);
    EXPECT_NEAR(now[0].at.x(), gone, 1e-15 * 4);
    EXPECT_NEAR(now[1].at.x(), 6 - gone, 1e-15 * 8);
  }
}

TEST(MakeTimeline, AFrameIsTheSameWhateverTheLastOne) {
  const Scene scene = scene_at("scenes/collision/gas.toml");
  const Timeline all = timeline_of(scene, scene.frames);
  EXPECT_GT(all.events().size(), 500U);
  for (unsigned frame = 1; frame <= scene.frames; frame += 17) {
    const auto whole = entity_states(all, frame);
    const auto alone = entity_states(timeline_of(scene, frame), frame);
    for (std::size_t i = 0; i < whole.size(); ++i) ASSERT_EQ(whole[i].at, alone[i].at);
  }
}

// A ray of finite speed meets mirrors where the events to come put them, between the frames.
TEST(MakeTimeline, MovingMirrorsAreTheSameWhateverTheLastFrame) {
  const std::string ray = "[[ray]]\nat = [0, 5]\ndirection = [1, 0]\nspeed = 2\n";
  const Scene scene = text_scene(disc_entity("material = \"mirror\"\nat = [0.1, 0.2]") +
                                     disc_entity("at = [-4.2, 0.9]\nvelocity = [1, 0]") + ray,
                                 kBounce);
  EXPECT_EQ(moving_walls(timeline_of(scene, 1)).motions.size(), 2U);
  EXPECT_EQ(timeline_of(scene, 1).events().size(), timeline_of(scene, 41).events().size());
}

// With events at the very times of frames, too.
TEST(MakeTimeline, TheFrameOfAnEventIsTheSameAlone) {
  const Scene scene = scene_at("scenes/collision/cradle.toml");
  const Timeline all = timeline_of(scene, scene.frames);
  EXPECT_EQ(all.events().size(), 3U);
  for (unsigned frame = 1; frame <= scene.frames; ++frame)
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_EQ(entity_states(all, frame)[i].at,
                entity_states(timeline_of(scene, frame), frame)[i].at);
}

TEST(MakeTimeline, MassesAreThoseGivenOrElseAreas) {
  const Scene scene = text_scene(
      disc_entity("velocity = [1, 0]\nmass = 3") + disc_entity("at = [6, 0]\nmass = 1"), kBounce);
  const Timeline timeline = timeline_of(scene, 100);
  ASSERT_EQ(timeline.events().size(), 1U);
  EXPECT_EQ(timeline.events()[0].velocity_a, Vec2(0.5, 0));
  EXPECT_EQ(timeline.events()[0].velocity_b, Vec2(1.5, 0));
  const Scene walled = text_scene(
      disc_entity("velocity = [1, 0]") + disc_entity("at = [6, 0]\nmass = \"fixed\""), kBounce);
  EXPECT_EQ(timeline_of(walled, 100).events()[0].velocity_a, Vec2(-1, 0));
}

TEST(MakeTimeline, WhatDoesNotRespondIsPassedThrough) {
  const Scene scene =
      text_scene(disc_entity("velocity = [1, 0]") +
                     disc_entity("at = [6, 0]\nangular_velocity = 9\nresponse = \"none\""),
                 kBounce);
  EXPECT_TRUE(timeline_of(scene, 100).events().empty());
  EXPECT_TRUE(timeline_of(scene, 100).stages(1).empty());
}

TEST(MakeTimeline, AMarkPushesNothingAndIsToldOnce) {
  const Scene scene = text_scene(disc_entity("velocity = [1, 0]") +
                                     disc_entity("at = [6, 0]\nresponse = \"mark\"") +
                                     disc_entity("at = [9, 0]\nmass = \"fixed\""),
                                 kBounce);
  const Timeline timeline = timeline_of(scene, 200);
  ASSERT_EQ(timeline.events().size(), 2U);  // on the way back it is still in it
  EXPECT_EQ(timeline.events()[0].time, 4);
  EXPECT_EQ(timeline.events()[0].velocity_a, Vec2(1, 0));
  EXPECT_EQ(timeline.events()[1].b, 2U);
  EXPECT_EQ(entity_states(timeline, 200)[1].at, Vec2(6, 0));
}

TEST(MakeTimeline, WhatBouncesOffWhatStopsFindsAWall) {
  const Scene scene =
      text_scene(disc_entity("velocity = [1, 0]") +
                     disc_entity("at = [6, 0]\nvelocity = [-1, 0]\nresponse = \"stop\""),
                 kBounce);
  const Timeline timeline = timeline_of(scene, 41);
  ASSERT_EQ(timeline.events().size(), 1U);
  EXPECT_EQ(timeline.events()[0].velocity_a, Vec2(-1, 0));
  EXPECT_EQ(timeline.events()[0].velocity_b, Vec2(0, 0));
}

TEST(MakeTimeline, VelocitiesInAGroupThatStandsAreTurnedAndScaledWithIt) {
  const Scene scene =
      text_scene(disc_entity("group = \"g\"\nvelocity = [1, 0]") + disc_entity("at = [0, 12]"),
                 kBounce + "[[group]]\nname = \"g\"\nangle = 90\nscale = 2\n");
  const Timeline timeline = timeline_of(scene, 100);
  ASSERT_EQ(timeline.events().size(), 1U);
  EXPECT_EQ(timeline.events()[0].time, 4.5);  // radii 2 and 1, 2 units a second
}

TEST(MakeTimeline, AJamIsRefusedOnlyForFramesBehindIt) {
  const Scene scene =
      text_scene(disc_entity("velocity = [1, 0]\nmass = \"fixed\"") + disc_entity("at = [6, 0]") +
                     disc_entity("at = [12, 0]\nvelocity = [-1, 0]\nmass = \"fixed\""),
                 kBounce);
  EXPECT_TRUE(make_timeline(scene, 0, 30));
  const auto jammed = make_timeline(scene, 0, 60);
  ASSERT_FALSE(jammed);
  EXPECT_NE(format(jammed.error()).find("test.toml:4:14: error: bodies are jammed"),
            std::string::npos)
      << format(jammed.error());
}

TEST(MakeTimeline, MoreEventsThanAllowedAreRefused) {
  const Scene scene = text_scene(disc_entity("velocity = [1, 0]") + disc_entity("at = [6, 0]") +
                                     disc_entity("at = [10, 0]\nmass = \"fixed\""),
                                 "collisions = { response = \"bounce\", most = 2 }\n");
  EXPECT_TRUE(make_timeline(scene, 0, 41));
  const auto cut = make_timeline(scene, 0, 500);
  ASSERT_FALSE(cut);
  EXPECT_NE(format(cut.error()).find("2 events before"), std::string::npos);
}

// Events at t = 4, 5.975 and 7.95, between frames 80 and 81.
TEST(MakeTimeline, AsManyEventsAsAllowedAreNotTooMany) {
  const Scene scene = text_scene(disc_entity("velocity = [1, 0]") + disc_entity("at = [6, 0]") +
                                     disc_entity("at = [9.975, 0]\nmass = \"fixed\""),
                                 "collisions = { response = \"bounce\", most = 2 }\n");
  EXPECT_TRUE(make_timeline(scene, 0, 80));
  EXPECT_FALSE(make_timeline(scene, 0, 81));
}

// At t = 4 of 10 frames a second: in frame 41, not in frame 40.
TEST(MakeTimeline, AHitSetsTheStateOfTheChain) {
  const Scene scene = text_scene(
      disc_entity("velocity = [1, 0]") +
          disc_entity("at = [6, 0]\nresponse = \"mark\"\nmarkov = { chain = \"c\", hit = \"ON\" }"),
      kBounce + "markov.c = { OFF = { OFF = 1 }, ON = { ON = 1 } }\n");
  const Timeline timeline = timeline_of(scene, 50);
  EXPECT_EQ(timeline.markov(1, 40).state, 0U);
  EXPECT_EQ(timeline.markov(1, 41).state, 1U);
  EXPECT_EQ(timeline.markov(1, 50).state, 1U);
  EXPECT_EQ(timeline_of(scene, 41).markov(1, 41).state, 1U);
}

TEST(MakeTimeline, WhatIsRemovedIsNeitherDrawnNorAMirror) {
  const Scene scene =
      text_scene(disc_entity("velocity = [1, 0]") +
                     disc_entity("at = [6, 0]\nresponse = \"remove\"\nmaterial = \"mirror\""),
                 kBounce);
  const Timeline timeline = timeline_of(scene, 60);
  const FrameState before = at(timeline, 40), after = at(timeline, 41);
  EXPECT_FALSE(before.entities[1].gone);
  EXPECT_TRUE(after.entities[1].gone);
  EXPECT_EQ(build_world(scene, before).surfaces.size(), 1U);
  EXPECT_EQ(build_world(scene, after).surfaces.size(), 0U);
  const RenderPlan plan = make_plan(scene, false);
  EXPECT_EQ(draw_list(plan, timeline, 40)->items.size(), 2U);
  EXPECT_EQ(draw_list(plan, timeline, 41)->items.size(), 1U);
}

// A disc, then: a point, a normal, two ghosts, a bar and its mark.
TEST(DrawnContact, ShowsAnEventFromItsTimeUntilItHasFaded) {
  const Scene scene = text_scene(
      disc_entity("velocity = [1, 0]") + disc_entity("at = [6, 0]"),
      "collisions = { response = \"bounce\", points = \"#ff0000\", normals = { width_px = 1 }, "
      "ghosts = { width_px = 1 }, time_bar = { width_px = 1 }, shown = 1 }\n"
      "film = { world = [[-10, -10], [20, 10]] }\n");
  const Timeline timeline = timeline_of(scene, 60);
  const RenderPlan plan = make_plan(scene, false);
  const auto items = [&](unsigned frame) { return draw_list(plan, timeline, frame)->items.size(); };
  EXPECT_EQ(items(1), 4U);
  EXPECT_EQ(items(40), 4U);
  EXPECT_EQ(items(41), 8U);
  EXPECT_EQ(items(50), 8U);
  EXPECT_EQ(items(51), 4U);
}

// The bar shows what is to come, so a frame alone looks as far ahead as the scene goes.
TEST(DrawnContact, TheBarOfAFrameAloneHoldsAllEvents) {
  const Scene scene = scene_at("scenes/collision/impact.toml");
  const Timeline all = timeline_of(scene, scene.frames), alone = timeline_of(scene, 1);
  EXPECT_EQ(all.events().size(), 2U);
  EXPECT_EQ(picture(all, 1).pixels, picture(alone, 1).pixels);
}

}  // namespace
}  // namespace flatray
