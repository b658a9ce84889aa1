// needs: shapes/box shapes/cell shapes/circle
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "study/chamber_scenes.h"
#include "study/rooms/room.h"

namespace flatray {
namespace {

using namespace flatray::testing;

Scene periodic(const std::string& cell, const std::string& discs) {
  return chamber_with(cell, "material = \"periodic\"\npillars = [" + discs + "]\n",
                      "size = [8, 8]");
}
std::string disc(const std::string& centre) {
  return "{ shape = { circle = { centre = [" + centre + "], radius = 1 } } }";
}

// The triangular Lorentz gas with a gap of 0.3, in three cells.
const std::string kLattice = "a = [2.3, 0], b = [1.15, 1.9918584287042087]";
Scene hexagonal() { return periodic("cell = { " + kLattice + ", sides = 6 }", disc("0, 0")); }
Scene oblique() {
  return periodic("cell = { " + kLattice + " }", disc("-1.7249999999999999, -0.9959292143521044"));
}
Scene upright() {
  return periodic("box = { min = [0, 0], max = [2.3, 3.9837168574084174] }",
                  disc("1.15, 1.9918584287042087") + ", " + disc("0, 0"));
}

// By benchmarks/lorentz_diffusion, which knows no cells.
constexpr double kDiffusion = 0.248332;  // +- 0.0004

TEST(Transport, OfTheTriangularGasIsThatOfAnIndependentProgramInEveryCell) {
  for (const Scene& scene : {hexagonal(), oblique(), upright()}) {
    const ExperimentResult result =
        run("transport", {.scene = scene, .count = 80'000, .bounces = 128});
    for (const char* name : {"diffusion_einstein", "diffusion_einstein_x", "diffusion_einstein_y",
                             "diffusion_green_kubo"}) {
      const Measure found = measure(result, name);
      ASSERT_TRUE(found.standard_error) << name << found.remark;
      EXPECT_LT(std::fabs(found.value - kDiffusion), 4 * *found.standard_error) << name;
      EXPECT_LT(*found.standard_error, 0.05 * kDiffusion) << name;
    }
    EXPECT_NEAR(measure(result, "sines_off_even").value, 1, 0.8);
  }
}

TEST(Transport, AreasAndWallsOfDiscsAcrossTheWallsCountOnce) {
  const double area = 2.3 * 1.9918584287042087 - std::numbers::pi;
  for (const Scene& scene : {hexagonal(), oblique()}) {
    const Room room(scene);
    EXPECT_NEAR(room.solids().free_area(), area, 1e-14);
    EXPECT_NEAR(room.perimeter(), 2 * std::numbers::pi, 1e-14);
    const ExperimentResult result = run("mean-free-path", {.scene = scene, .count = 20'000});
    EXPECT_NEAR(*measure(result, "mean_free_path").expected, area / 2, 1e-14);
    EXPECT_TRUE(result.holds);
  }
}

// A quarter of the disc of each corner, and none of them twice: starts are even along it.
TEST(Transport, StartsOnDiscsAcrossTheWallsAreOnTheirCopiesInTheCell) {
  const Scene scene = oblique();
  const Room room(scene);
  double cosines = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const OrbitStart start = room.draw_start(1, i);
    EXPECT_TRUE(room.solids().in_chamber(start.ray.origin));
    const Vec2 from = start.ray.origin - room.walls().arc(start.departed.surface).curve.centre;
    EXPECT_NEAR(from.norm(), 1, 1e-14);
    cosines += from.x();
  }
  EXPECT_NEAR(cosines / 2000, 0, 4 * std::sqrt(0.5 / 2000));
}

// Corridors of width w = 1/2 along x and y, and 1/sqrt 2 - 1/2 along both diagonals, sqrt 2 long in each
// cell: the sum of w^2 l / (2 pi A), which is come near to as slowly as 1 / log t.
TEST(Transport, OfAnInfiniteHorizonGrowsByTheLogarithmOfTime) {
  const Scene scene = torus("0.25");
  const ExperimentResult result =
      run("transport", {.scene = scene, .count = 200'000, .bounces = 512});
  const Measure slope = measure(result, "diffusion_per_log_time");
  EXPECT_FALSE(slope.standard_error);
  EXPECT_TRUE(has(result.summary, "there is no D"));
  const double area = 1 - std::numbers::pi / 16, diagonal = std::sqrt(0.5) - 0.5;
  const double limit =
      (0.5 + 2 * diagonal * diagonal * std::sqrt(2.0)) / (2 * std::numbers::pi * area);
  EXPECT_GT(slope.value, 0.6 * limit);  // so early it is not yet near
  EXPECT_LT(slope.value, 1.8 * limit);
}

// A wind-tree: between straight walls t log t is not claimed.
TEST(Transport, BetweenStraightWallsClaimsNoLaw) {
  const Scene scene = periodic("box = { min = [0, 0], max = [2, 2] }",
                               "{ shape = { box = { min = [0.5, 0.5], max = [1.5, 1.25] } } }");
  const ExperimentResult result =
      run("transport", {.scene = scene, .count = 200'000, .bounces = 128});
  const Measure power = measure(result, "power_of_displacement");
  EXPECT_FALSE(power.standard_error);
  EXPECT_GT(power.value, 0.8);
  EXPECT_LE(power.value, 2);
  EXPECT_FALSE(has(result.summary, "log"));
}

TEST(Transport, IsRefusedWhereNothingSpreads) {
  const auto result = experiment("transport").run({.scene = sinai("0.25")});
  ASSERT_FALSE(result);
  EXPECT_TRUE(has(format(result.error()), "nothing diffuses"));
}

// Whatever the threads.
TEST(Transport, HasTheSameBytesOnOneThreadAndOnThree) {
  const Scene scene = hexagonal();
  expect_same_files(run("transport", {.scene = scene, .count = 20'000}),
                    run("transport", {.scene = scene, .count = 20'000, .threads = 3}));
}

}  // namespace
}  // namespace flatray
