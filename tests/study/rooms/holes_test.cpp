// needs: shapes/box shapes/circle shapes/capsule
// Holes of a chamber's walls: who leaves, and who does not.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "study/chamber_scenes.h"
#include "study/rooms/room.h"

namespace flatray {
namespace {

using namespace flatray::testing;

constexpr double kFullTurn = 6.28318530717958648;

const char* const kHoledBox = "box = { min = [0, 0], max = [4, 4] }";

std::string said_of_holes(const std::string& shape, const std::string& holes) {
  const auto loaded = load_scene_text("room.toml", "flatray = 1\n[[chamber]]\nshape = { " + shape +
                                                       " }\nholes = [" + holes + "]\n");
  return loaded ? "" : format(loaded.error());
}

// Which hole an orbit leaves by at the first wall; -1: none.
int first_hole(const Room& room, const Ray& ray) {
  const Orbit orbit = trace_orbit(room.walls(), room.materials(), ray, 1);
  if (orbit.end != OrbitEnd::absorbed) return -1;
  return static_cast<int>(room.owner(orbit.end_surfaces.front()).hole);
}

// A box has its lower edge first. What arrives at an end of the hole leaves, one double beside it bounces.
TEST(Holes, AreClosed) {
  const Scene scene = with_holes(kHoledBox, "{ edge = 0, from = 0.25, to = 0.5 }");
  const Room room(scene);
  const auto down = [&](double x) { return first_hole(room, {{x, 3}, {0, -1}}); };
  EXPECT_EQ(down(1), 0);
  EXPECT_EQ(down(2), 0);
  EXPECT_EQ(down(1.5), 0);
  EXPECT_EQ(down(std::nextafter(1.0, 0.0)), -1);
  EXPECT_EQ(down(std::nextafter(2.0, 3.0)), -1);
  for (const bool upper : {false, true})  // at an angle, exactly at an end
    EXPECT_EQ(first_hole(room, {{upper ? 3.0 : 0.0, 1}, {upper ? -1.0 : 1.0, -1}}), 0);
}

// From the centre a circle is met at the angle of the ray, whatever side of its beginning the hole is.
TEST(Holes, OfACircleTakeTheirAngles) {
  for (const auto& [from, to] : {std::pair(0.1, 0.35), std::pair(0.9, 1.1), std::pair(0.2, 0.95)}) {
    const Scene scene =
        with_holes("circle = { radius = 2 }", fmt::format("{{ from = {}, to = {} }}", from, to));
    const Room room(scene);
    for (int i = 0; i < 720; ++i) {
      const double share = (i + 0.25) / 720, angle = kFullTurn * share;
      const bool in = (share > from && share < to) || share + 1 < to;
      EXPECT_EQ(first_hole(room, {{0, 0}, {std::cos(angle), std::sin(angle)}}), in ? 0 : -1)
          << share;
    }
    EXPECT_NEAR(room.perimeter(), 2 * kFullTurn, 1e-12);
  }
}

// Parts share their ends: every orbit stays or leaves by a hole.
TEST(Holes, LeakNowhereElse) {
  const Scene scene = with_holes("capsule = { from = [-1, 0], to = [0.7, 0.3], radius = 0.9 }",
                                 "{ edge = 0, from = 0.2, to = 0.23 }, { edge = 1, from = 0.6, to "
                                 "= 0.7 }, { edge = 2, from = 0, to = 0.1 }, { edge = 3, from = "
                                 "0.95, to = 1 }, { edge = 0, from = 0.5, to = 0.51 }");
  const Room room(scene);
  std::array<int, 5> by{};
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const Orbit orbit =
        trace_orbit(room.walls(), room.materials(), room.draw_start(1, i).ray, 10000);
    ASSERT_EQ(orbit.end, OrbitEnd::absorbed) << i;
    ++by[room.owner(orbit.end_surfaces.front()).hole];
  }
  for (const int count : by) EXPECT_GT(count, 20);
}

TEST(Holes, AreRefusedWhereTheyCannotBe) {
  EXPECT_TRUE(has(said_of_holes(kHoledBox, "{ edge = 4, from = 0, to = 0.1 }"), "no edge 4"));
  EXPECT_TRUE(has(said_of_holes(kHoledBox, "{ from = 0.5, to = 1.1 }"), "beyond its edge"));
  EXPECT_TRUE(has(said_of_holes(kHoledBox, "{ from = 0.5, to = 0.4 }"), "nowhere"));
  EXPECT_TRUE(
      has(said_of_holes(kHoledBox, "{ from = 0, to = 0.5 }, { from = 0.4, to = 0.6 }"), "overlap"));
  EXPECT_TRUE(
      has(said_of_holes("circle = { radius = 1 }", "{ from = 0, to = 1 }"), "all of its wall"));
  EXPECT_TRUE(has(
      said_of_holes("circle = { radius = 1 }", "{ from = 0, to = 0.5 }, { from = 0.9, to = 1.05 }"),
      "overlap"));
  EXPECT_TRUE(
      has(said_of_holes("segment = { from = [0, 0], to = [1, 0] }", "{ from = 0, to = 0.5 }"),
          "enclose nothing"));
  EXPECT_EQ(said_of_holes(kHoledBox, "{ from = 0, to = 0.5 }, { from = 0.5, to = 0.6 }"), "");
}

}  // namespace
}  // namespace flatray
