// needs: shapes/box shapes/circle shapes/capsule experiments/mean_free_path experiments/lyapunov
// Rooms in a magnetic field, by closed forms and by neighbours that are followed.
#include <gtest/gtest.h>

#include <cmath>

#include "study/chamber_scenes.h"
#include "study/rooms/free_circles.h"
#include "study/rooms/tangent.h"

namespace flatray {
namespace {

using namespace flatray::testing;

constexpr double kPiHere = 3.141592653589793;

Scene room_in_field(const std::string& shape, const std::string& pillars,
                    const std::string& field) {
  return chamber_with(shape, "pillars = [" + pillars + "]\nfield = " + field + "\n");
}

const std::string kUnitBox = "box = { min = [0, 0], max = [1, 1] }";
const std::string kUnitCircle = "circle = { radius = 1 }";

TEST(FreeCircles, HaveTheCentresOfClosedForms) {
  const Scene square = room(kUnitBox), circle = room(kUnitCircle);
  const Scene capsule = room("capsule = { from = [-1, 0], to = [1, 0], radius = 1 }");
  const Scene annulus = room(kUnitCircle, "{ shape = { circle = { radius = 0.2 } } }");
  EXPECT_NEAR(area_of_free_centres(Room(square), 0.3), 0.4 * 0.4, 1e-4);
  EXPECT_EQ(area_of_free_centres(Room(square), 0.6), 0);
  EXPECT_NEAR(area_of_free_centres(Room(circle), 0.4), kPiHere * 0.36, 1e-4);
  EXPECT_NEAR(area_of_free_centres(Room(capsule), 0.5), kPiHere * 0.25 + 2, 1e-4);
  // Round the pillar, or beside it.
  EXPECT_NEAR(area_of_free_centres(Room(annulus), 0.6), kPiHere * 0.16, 1e-4);
  EXPECT_NEAR(area_of_free_centres(Room(annulus), 0.3), kPiHere * (0.49 - 0.25 + 0.01), 1e-4);
}

// What circles freely is not in the mean: pi (A - centres of free circles) / P.
TEST(FieldRooms, MeanFlightsAreThoseOfSantaloWithoutFreeCircles) {
  for (const char* field : {"0.5", "-4"}) {
    const Scene scene = room_in_field(
        kUnitBox, "{ shape = { circle = { centre = [0.5, 0.5], radius = 0.2 } } }", field);
    const ExperimentResult result = run("mean-free-path", {scene, 1, 20000, 1});
    const Measure mean = measure(result, "mean_free_path");
    ASSERT_TRUE(mean.standard_error && mean.expected);
    EXPECT_NEAR(mean.value, *mean.expected, 4 * *mean.standard_error) << field;
    EXPECT_LT(*mean.standard_error, 0.03 * mean.value);
    EXPECT_EQ(measure(result, "orbits_escaped").value, 0);
  }
}

// The area of free circles is known to 1e-4 of the box: a share of what is left of it by a strong field.
TEST(FieldRooms, NothingIsJudgedByAClosedFormThatIsTooCoarse) {
  const Measure mean =
      measure(run("mean-free-path", {room_in_field(kUnitCircle, "", "1000"), 1, 60000, 1}),
              "mean_free_path");
  EXPECT_NEAR(mean.value, kPiHere * kPiHere * 2e-3 / (2 * kPiHere),
              4 * *mean.standard_error + 1e-5);
  EXPECT_FALSE(mean.expected.has_value());
  EXPECT_TRUE(has(mean.remark, "too coarse to judge by"));
  EXPECT_FALSE(experiment("mean-free-path")
                   .run({.scene = room_in_field(kUnitCircle, "", "1e5"), .count = 1000}));
}

// The place and angle of an orbit beside another, across the ray.
Tangent seen_from(const Vec2& point, const Vec2& way, const Vec2& other, const Vec2& other_way,
                  double field) {
  const Vec2 apart = other - point;
  const double angle = std::asin(cross(way, other_way));
  return {cross(way, apart), angle - field * way.dot(apart)};
}

TEST(FieldRooms, TangentsAreNeighbours) {
  constexpr double kApart = 1e-7;
  const double field = 0.9;
  const Scene scene = room_in_field(
      kUnitBox, "{ shape = { circle = { centre = [0.5, 0.5], radius = 0.2 } } }", "0.9");
  const Room rooms(scene);
  const Vec2 from(0.13, 0.31), way(0.6, 0.8), left(-0.8, 0.6);
  for (const double turned : {0.0, 1.0}) {  // apart, or at an angle
    const double angle = turned * kApart;
    const Vec2 beside = from + (1 - turned) * kApart * left;
    const Vec2 other_way = std::cos(angle) * way + std::sin(angle) * left;
    const std::vector<Ray> starts{{from, way}, {beside, other_way}};
    const std::vector<Orbit> both = trace_orbits(rooms.orbits(), starts, 5);
    Tangent tangent{1 - turned, turned};
    for (std::size_t i = 0; i < 5; ++i) {
      const Bounce& one = both[0].bounces[i];
      const Bounce& other = both[1].bounces[i];
      ASSERT_EQ(one.surface, other.surface);
      const double bend = curvature(rooms.walls(), one.surface, one.point, one.normal);
      tangent.fly(one.t, field);
      tangent.reflect(bend_in_field(one, bend, field));
      const Tangent seen = seen_from(one.point, one.out, other.point, other.out, field);
      const double size = std::hypot(tangent.q, tangent.p);
      EXPECT_NEAR(seen.q / kApart, tangent.q, 1e-3 * size) << i;
      EXPECT_NEAR(seen.p / kApart, tangent.p, 1e-3 * size) << i;
    }
  }
}

// Areas across the ray stay: the determinant of flights and mirrors is 1.
TEST(FieldRooms, TangentsKeepAreas) {
  Tangent a{1, 0}, b{0, 1};
  for (int i = 0; i < 6; ++i)
    for (Tangent* one : {&a, &b}) {
      one->fly(0.3 + 0.1 * i, 1.3);
      one->reflect(i % 3 - 1.2);
    }
  EXPECT_NEAR(a.q * b.p - a.p * b.q, 1, 1e-9);
}

TEST(FieldRooms, TheSpectrumSumsToZero) {
  const ExperimentResult result = run("lyapunov", {sinai("0.2"), 1, 40000, 1});
  double sum = measure(result, "per_length").value;
  for (const char* name : {"spectrum_2", "spectrum_3", "spectrum_4"})
    sum += measure(result, name).value;
  EXPECT_EQ(sum, 0);
}

// Integrable in every field: no exponent is told.
TEST(FieldRooms, ACircleInAFieldPartsNothingExponentially) {
  const Scene scene = room_in_field(kUnitCircle, "", "0.7");
  const ExperimentResult result = run("lyapunov", {scene, 1, 40000, 1});
  EXPECT_FALSE(measure(result, "finite_time_per_length").standard_error.has_value());
}

TEST(FieldRooms, WhatNoFlightIsBentAmongIsRefused) {
  const auto refused = [](const std::string& text) {
    const auto loaded = load_scene_text("room.toml", "flatray = 1\n" + text);
    return loaded ? std::string() : loaded.error().front().message;
  };
  const std::string box = "[[chamber]]\nshape = { " + kUnitBox + " }\nfield = 1\n";
  EXPECT_EQ(refused(box), "");
  EXPECT_EQ(refused("[[chamber]]\nfield = 5e-324\nshape = { " + kUnitBox + " }\n"),
            "a magnetic field of 5e-324");
  EXPECT_EQ(refused(box + "material = \"periodic\"\n"), "no periodic walls in a magnetic field");
  EXPECT_EQ(refused("[[chamber]]\nfield = 1\nshape = { ellipse = { radii = [2, 1] } }\n"),
            "no ellipses or Bezier curves in a magnetic field");
  EXPECT_EQ(refused(box + "[[ray]]\nat = [0.5, 0.5]\ndirection = [1, 0]\nspeed = 1\n"),
            "a ray of finite speed in a magnetic field");
  EXPECT_EQ(refused(box + "[[entity]]\nmaterial = \"mirror\"\nshape = { " + kUnitBox + " }\n"),
            "an entity that rays meet, in a magnetic field");
  EXPECT_EQ(
      refused(box + "[[lamp]]\nsource = { segment = { from = [0.2, 0.5], to = [0.8, 0.5] } }\n"),
      "a lamp in a magnetic field, which bends rays");
}

}  // namespace
}  // namespace flatray
