// needs: lamps/point shapes/box formats/toml
// Lamps that go through the states of a chain.
#include <gtest/gtest.h>

#include "anim/lamps.h"
#include "anim/motion.h"
#include "base/check.h"
#include "scene/load.h"

namespace flatray {
namespace {

Scene flickering(const std::string& rest, const std::string& chain) {
  auto made = load_scene_text(
      "t.toml", "flatray = 1\nframes = 9\nfps = 10\n[[lamp]]\nsource = { point = {} }\n" + rest +
                    "\n[markov.c]\n" + chain + "\n");
  FLATRAY_CHECK(made.has_value(), made ? "" : format(made.error()));
  return std::move(made->scene);
}

constexpr const char* kTurns = "A = { B = 1 }\nB = { A = 1 }";  // no chance in it

TEST(LampStates, TurnALampOnAndOffAndChangeItsColour) {
  const Scene made = flickering(
      "kelvin = 3000\nmarkov = { chain = 'c' }\n"
      "states = { A = [{ nm = 500 }, { colour = '#ff0000', power = 4 }], B = { power = 0 } }",
      std::string("hold = 2\n") + kTurns);
  const Timeline timeline(made, 0, 9);
  const auto states = [&](unsigned frame) { return lamp_states(made, at(timeline, frame)); };
  ASSERT_EQ(states(1).size(), 1U);
  EXPECT_EQ(states(1)[0].nm, 500);
  EXPECT_EQ(states(1)[0].colour, colour_of_wavelength(500));
  EXPECT_EQ(states(2)[0].nm, 0);
  EXPECT_EQ(states(2)[0].power, 4);
  EXPECT_EQ(states(2)[0].colour, (LightColour{1, 0, 0}));
  EXPECT_TRUE(states(3).empty());
  EXPECT_TRUE(states(4).empty());
  EXPECT_EQ(states(5)[0].nm, 500);
  EXPECT_TRUE(moves(made.lamps[0]));
  EXPECT_EQ(reason_to_move(made), "lamp of line 4 moves");
}

TEST(LampStates, WithoutALookAreTheLampItself) {
  const Scene made =
      flickering("nm = 450\nmarkov = { chain = 'c' }\nstates = { A = { nm = 600 } }", kTurns);
  const Timeline timeline(made, 0, 9);
  EXPECT_EQ(lamp_states(made, at(timeline, 1))[0].nm, 600);
  EXPECT_EQ(lamp_states(made, at(timeline, 2))[0].nm, 450);
}

// Three frames of 0.1 s in A, B and A.
TEST(LampStates, MoveALampByTheSumOfTheirVelocities) {
  const Scene made = flickering(
      "at = [1, 1]\nvelocity = [0, 20]\nmarkov = { chain = 'c' }\n"
      "states = { A = { velocity = [10, 0] } }",
      kTurns);
  const Timeline timeline(made, 0, 9);
  const Vec2 there = lamp_states(made, at(timeline, 4))[0].pose.at;
  EXPECT_NEAR(there.x(), 3, 1e-14);
  EXPECT_NEAR(there.y(), 3, 1e-14);
}

// The walk of a lamp is its own: neither its copies' nor that of the entity of its number.
TEST(LampStates, OfCopiesAreDrawnApart) {
  const Scene made = flickering(
      "markov = { chain = 'c' }\nstates = { B = { power = 0 } }\n"
      "repeat = { grid = { count = [2, 1], step = [1, 0] } }\n"
      "[[entity]]\nshape = { box = { min = [0, 0], max = [1, 1] } }\nmarkov = { chain = 'c' }",
      "A = { A = 0.5, B = 0.5 }\nB = { A = 0.5, B = 0.5 }");
  constexpr unsigned kFrames = 2000;
  const Timeline timeline(made, 7, kFrames);
  unsigned same = 0, as_entity = 0, on = 0;
  for (unsigned frame = 2; frame <= kFrames; ++frame) {
    const StateId first = timeline.lamp(0, frame).state;
    same += first == timeline.lamp(1, frame).state;
    as_entity += first == timeline.markov(0, frame).state;
    on += first == 0;
  }
  for (const unsigned count : {same, as_entity, on})
    EXPECT_NEAR(count, kFrames / 2, 110);  // 5 sigma
}

TEST(LampStates, OfAFrameAloneAreThoseOfTheRun) {
  const Scene made = flickering("markov = { chain = 'c' }\nstates = { B = { power = 0 } }",
                                "A = { A = 0.7, B = 0.3 }\nB = { A = 0.5, B = 0.5 }");
  const Timeline run(made, 3, 300);
  for (const unsigned frame : {1U, 17U, 123U, 300U})
    EXPECT_EQ(Timeline(made, 3, frame).lamp(0, frame).state, run.lamp(0, frame).state) << frame;
}

}  // namespace
}  // namespace flatray
