// needs: shapes/box shapes/circle shapes/lens shapes/capsule shapes/ellipse materials/glass experiments/mean_free_path experiments/lyapunov experiments/poincare experiments/phase_portion experiments/escape
// Rooms with glass: orbits are split by chance, with Fresnel's parts, and bent by Snell's law.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/entry_named.h"
#include "geom/refract.h"
#include "study/accuracy/accuracy.h"
#include "study/chamber_scenes.h"
#include "study/rooms/room.h"
#include "study/rooms/tangent.h"
#include "study/statistics/estimate.h"

namespace flatray {
namespace {

using namespace flatray::testing;

constexpr double kPiOfDiscs = std::numbers::pi;
const std::string kEmptyBox = "box = { min = [0, 0], max = [1, 1] }";

Scene box_with(const std::string& shape, const std::string& index) {
  return room(kEmptyBox,
              "{ shape = { " + shape + " }, material = { glass = { index = " + index + " } } }");
}
Scene disc_of(const std::string& index) {
  return box_with("circle = { centre = [0.5, 0.5], radius = 0.25 }", index);
}
Scene slab_of(const std::string& index) {
  return box_with("box = { min = [0.3, 0.1], max = [0.6, 0.9] }", index);
}

Orbit orbit_of(const Room& room, const Ray& ray, std::uint64_t bounces, std::uint64_t chance) {
  const OrbitStart start{ray, {}, chance};
  return trace_orbits(room.orbits(), std::span(&start, 1), bounces).front();
}

// How many of `count` orbits the first glass they come to reflects.
double reflected_share(const Room& room, const Ray& ray, int count) {
  std::vector<OrbitStart> starts;
  for (int i = 0; i < count; ++i)
    starts.push_back({ray, {}, chance_of_orbit(7, static_cast<std::uint64_t>(i))});
  int reflected = 0;
  for (const Orbit& orbit : trace_orbits(room.orbits(), starts, 1))
    reflected += orbit.bounces.at(0).is_refracted() ? 0 : 1;
  return static_cast<double>(reflected) / count;
}

TEST(GlassOrbits, AreReflectedAsOftenAsFresnelSays) {
  constexpr int kCount = 40000;
  for (const auto& [index, n] : {std::pair("1.5", 1.5), {"3", 3.0}, {"0.5", 0.5}}) {
    const Scene scene = slab_of(index);
    const Room rooms(scene);
    const double straight = std::pow((n - 1) / (n + 1), 2);
    const double share = reflected_share(rooms, {{0.1, 0.5}, {3, 0}}, kCount);
    EXPECT_NEAR(share, straight, 4 * std::sqrt(straight * (1 - straight) / kCount)) << index;
  }
  // At Brewster's angle, of tangent n, light polarised in the plane is not reflected at all.
  const Scene scene = slab_of("1.5");
  const double s = std::pow((1.5 * 1.5 - 1) / (1.5 * 1.5 + 1), 2) / 2;
  const double share = reflected_share(Room(scene), {{0.1, 0.3}, {1, 1.5}}, kCount);
  EXPECT_NEAR(share, s, 4 * std::sqrt(s * (1 - s) / kCount));
}

TEST(GlassOrbits, LeaveASlabParallelToHowTheyCame) {
  const Scene scene = slab_of("1.5");
  const Room rooms(scene);
  int through = 0;
  for (std::uint64_t chance = 0; chance < 40; ++chance) {
    const Orbit orbit = orbit_of(rooms, {{0.1, 0.3}, {0.4, 0.3}}, 2, chance);
    const auto& bounces = orbit.bounces;
    if (!bounces.at(0).is_refracted() || !bounces.at(1).is_refracted()) continue;
    ++through;
    EXPECT_NEAR(bounces[0].out.y() / bounces[0].out.norm(), 0.6 / 1.5, 1e-15);
    EXPECT_NEAR(bounces[0].out.norm(), 0.5, 1e-16);
    EXPECT_EQ(bounces[0].point.x(), 0.3);
    EXPECT_EQ(bounces[1].point.x(), 0.6);
    EXPECT_NEAR((bounces[1].out - orbit.direction).norm(), 0, 2e-16);
  }
  EXPECT_GT(through, 30);
}

// A face that is flat lets what comes straight at it through; at the round one, a circle, the sine of the angle
// of incidence is the height by the radius.
TEST(GlassOrbits, LeaveALensAsSnellsLawSays) {
  const Scene scene = box_with(
      "lens = { centre = [0.5, 0.5], height = 0.6, thickness = 0.2, radii = [0, 0.5] }", "1.5");
  const Room rooms(scene);
  int through = 0;
  for (const double height : {0.25, 0.1, 0.0, -0.2}) {
    for (std::uint64_t chance = 0; chance < 20; ++chance) {
      const Orbit orbit = orbit_of(rooms, {{0.1, 0.5 + height}, {1, 0}}, 2, chance);
      const auto& bounces = orbit.bounces;
      if (!bounces.at(0).is_refracted() || !bounces.at(1).is_refracted()) continue;
      ++through;
      const double sine = height / 0.5, bend = std::asin(1.5 * sine) - std::asin(sine);
      EXPECT_NEAR(bounces[0].out.y(), 0, 1e-15);
      EXPECT_NEAR(bounces[1].point.x(), 0.1 + std::sqrt(0.25 - height * height), 1e-15);
      EXPECT_NEAR(bounces[1].out.y(), -std::sin(bend), 1e-14) << height;
    }
  }
  EXPECT_GT(through, 60);
}

TEST(GlassOrbits, GoBackTheWayTheyCame) {
  const Scene scene = disc_of("1.5");
  const Room rooms(scene);
  for (std::uint64_t number = 0; number < 200; ++number) {
    const OrbitStart start = rooms.draw_start(3, number);
    const Orbit there = orbit_of(rooms, start.ray, 2, start.chance);
    if (there.bounces.size() < 2 || !there.bounces[0].is_refracted()) continue;
    const Bounce& met = there.bounces[0];
    const auto out =
        refraction(1 / rooms.index_ratio(met), std::fabs(met.out.dot(met.normal)) / met.out.norm());
    ASSERT_TRUE(out);
    const Vec2 back = out->of(-met.out / met.out.norm(), -met.normal);
    EXPECT_NEAR((back + met.in / met.in.norm()).norm(), 0, 1e-12 / out->beyond) << number;
    // Fresnel's parts are the same both ways.
    const auto in = refraction(rooms.index_ratio(met), out->beyond);
    EXPECT_NEAR(in->reflected, out->reflected, 1e-12);
  }
}

TEST(GlassOrbits, AreAllReflectedBeyondTheCriticalAngle) {
  const Scene scene = slab_of("1.25");  // of sine 0.8
  const Room rooms(scene);
  const auto refracted = [&](double sine) {
    int count = 0;
    for (std::uint64_t chance = 0; chance < 2000; ++chance) {
      const Ray ray{{0.4, 0.2}, {std::sqrt(1 - sine * sine), sine}};
      count += orbit_of(rooms, ray, 1, chance_of_orbit(1, chance)).bounces.at(0).is_refracted();
    }
    return count;
  };
  EXPECT_EQ(refracted(std::nextafter(0.8, 1) + 1e-15), 0);
  EXPECT_EQ(refracted(0.9), 0);
  EXPECT_GT(refracted(0.79), 500);
  EXPECT_FALSE(refraction(1.25, 0.5999999999999));
  EXPECT_TRUE(refraction(1.25, 0.6000000000001));
}

TEST(GlassOrbits, OfIndexOneAreThoseWithoutGlass) {
  const Scene with = slab_of("1"), without = room(kEmptyBox);
  const Room glass(with), empty(without);
  for (std::uint64_t number = 0; number < 50; ++number) {
    const Ray ray = empty.draw_start(5, number).ray;
    const Orbit free = orbit_of(empty, ray, 12, 0);
    std::size_t met = 0;
    for (const Bounce& one : orbit_of(glass, ray, 40, number).bounces) {
      if (one.surface >= 4) {
        EXPECT_TRUE(one.is_refracted());
        continue;
      }
      if (met == free.bounces.size()) break;
      EXPECT_EQ(one.surface, free.bounces[met].surface);
      EXPECT_NEAR((one.point - free.bounces[met].point).norm(), 0, 1e-12);
      EXPECT_NEAR(one.path_length, free.bounces[met].path_length, 1e-11);
      ++met;
    }
    EXPECT_GT(met, 8U);
  }
}

// In glass within glass the index around is that of the outer.
TEST(GlassOrbits, KnowTheGlassAroundGlass) {
  const Scene scene = scene_of(
      "film = { size = [32, 24] }\n[[entity]]\nshape = { box = { min = [0, 0], max = [1, 1] } }\n"
      "material = { glass = { index = 1.5 } }\n[[entity]]\nshape = { box = { min = [0.3, 0.3], "
      "max = [0.7, 0.7] } }\nmaterial = { glass = { index = 2.5 } }\n");
  const Room rooms(scene);
  int seen = 0;
  for (std::uint64_t chance = 0; chance < 20; ++chance) {
    const Orbit orbit = orbit_of(rooms, {{-1, 0.4}, {1, 0.1}}, 3, chance);
    if (orbit.bounces.size() < 3) continue;
    const double sine = 0.1 / std::sqrt(1.01);
    if (!orbit.bounces[0].is_refracted() || !orbit.bounces[1].is_refracted()) continue;
    ++seen;
    EXPECT_NEAR(orbit.bounces[0].out.y() / orbit.bounces[0].out.norm(), sine / 1.5, 1e-15);
    EXPECT_NEAR(orbit.bounces[1].out.y() / orbit.bounces[1].out.norm(), sine / 2.5, 1e-15);
  }
  EXPECT_GT(seen, 5);
  EXPECT_NEAR(reflected_share(rooms, {{0.1, 0.5}, {1, 0}}, 40000), 0.0625, 0.005);
}

std::string glass(const std::string& shape, double index) {
  return "[[entity]]\nshape = { " + shape +
         " }\nmaterial = { glass = { index = " + std::to_string(index) + " } }\n";
}
std::string glass_box(double left, double right, double low, double high, double index) {
  return glass("box = { min = [" + std::to_string(left) + ", " + std::to_string(low) +
                   "], max = [" + std::to_string(right) + ", " + std::to_string(high) + "] }",
               index);
}

// The index on each way, by Snell's law at upright walls, of an orbit that is refracted by all of them.
std::vector<double> indices_on_the_way(const std::string& scene, const Ray& ray,
                                       std::size_t walls) {
  const Scene read = scene_of("film = { size = [32, 24] }\n" + scene);
  const Room rooms(read);
  const auto sine = [](const Vec2& way) { return way.y() / way.norm(); };
  for (std::uint64_t chance = 0; chance < 2000; ++chance) {
    const Orbit orbit = orbit_of(rooms, ray, walls + 1, chance);
    if (orbit.bounces.size() != walls ||
        !std::ranges::all_of(orbit.bounces, [](const Bounce& one) { return one.is_refracted(); }))
      continue;
    std::vector<double> indices;
    for (const Bounce& one : orbit.bounces) indices.push_back(sine(ray.direction) / sine(one.out));
    return indices;
  }
  return {};
}

void expect_indices(const std::vector<double>& found, const std::vector<double>& right) {
  ASSERT_EQ(found.size(), right.size());
  for (std::size_t i = 0; i < right.size(); ++i) EXPECT_NEAR(found[i], right[i], 1e-12) << i;
}

TEST(GlassOrbits, KnowTheInnerOfTwoBodiesThatCross) {
  const Ray to{{-3, 0}, {2, 0.7}}, fro{{9, 0}, {-2, 0.7}};
  const std::string first = glass_box(0, 4, -5, 5, 1.5), second = glass_box(2, 6, -6, 4, 2.5);
  // Of the same area the later is the inner.
  expect_indices(indices_on_the_way(first + second, to, 4), {1.5, 2.5, 2.5, 1});
  expect_indices(indices_on_the_way(first + second, fro, 4), {2.5, 2.5, 1.5, 1});
  expect_indices(indices_on_the_way(second + first, to, 4), {1.5, 1.5, 2.5, 1});
  expect_indices(indices_on_the_way(second + first, fro, 4), {2.5, 1.5, 1.5, 1});
  // Else the smaller, in any order.
  const std::string small = glass_box(2, 6, -5, 4, 2.5);
  expect_indices(indices_on_the_way(first + small, to, 4), {1.5, 2.5, 2.5, 1});
  expect_indices(indices_on_the_way(small + first, to, 4), {1.5, 2.5, 2.5, 1});
}

TEST(GlassOrbits, KnowBodiesInOneAnotherInWhateverOrderAndHoweverMany) {
  for (const bool inner_first : {true, false}) {
    constexpr int kBodies = 12;
    std::string scene;
    std::vector<double> right;
    for (int i = 0; i < kBodies; ++i) {
      const int body = inner_first ? kBodies - 1 - i : i;
      const double size = 20 - body;
      scene += glass_box(-size, size, -size, size, 1.05 + 0.05 * body);
      right.push_back(1.05 + 0.05 * i);
    }
    for (int i = kBodies - 1; i-- > 0;) right.push_back(1.05 + 0.05 * i);
    right.push_back(1);
    expect_indices(indices_on_the_way(scene, {{-30, 0}, {1, 0.01}}, 2 * kBodies), right);
    // And where it sets off in the middle.
    right.erase(right.begin(), right.begin() + kBodies);
    std::vector<double> from_within = right;
    for (double& index : from_within) index /= 1.05 + 0.05 * (kBodies - 1);
    expect_indices(indices_on_the_way(scene, {{0.1, 0}, {1, 0.01}}, kBodies), from_within);
  }
}

// What has the same box is told apart by area.
TEST(GlassOrbits, KnowTheInnerOfBodiesWithOneBox) {
  const std::string square = glass_box(-1, 1, -1, 1, 1.5);
  for (const char* round : {"circle = { radius = 1 }", "ellipse = { radii = [1, 1], angle = 30 }",
                            "lens = { height = 2, thickness = 2, radii = [1, 1] }",
                            "capsule = { from = [0, 0], to = [0, 0.0001], radius = 1 }"}) {
    const std::string disc = glass(round, 2.0);
    for (const std::string& scene : {square + disc, disc + square}) {
      const Scene read = scene_of("film = { size = [32, 24] }\n" + scene);
      const Room rooms(read);
      const double share = reflected_share(rooms, {{-0.99, 0.5}, {1, 0}}, 4000);
      EXPECT_GT(share, 0.01) << round;  // at the circle, by an angle
    }
  }
}

std::vector<OrbitStart> drawn_starts(const Room& room, std::uint64_t seed, std::uint64_t count) {
  std::vector<OrbitStart> starts;
  for (std::uint64_t number = 0; number < count; ++number)
    starts.push_back(room.draw_start(seed, number));
  return starts;
}

// What is followed together, and alone, is the same orbit.
TEST(GlassOrbits, DependOnTheirOwnChanceAlone) {
  const Scene scene = disc_of("1.5");
  const Room rooms(scene);
  const std::vector<OrbitStart> starts = drawn_starts(rooms, 1, 40);
  const auto together = trace_orbits(rooms.orbits(), starts, 200);
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const Orbit alone = trace_orbits(rooms.orbits(), std::span(&starts[i], 1), 200).front();
    ASSERT_EQ(alone.bounces.size(), together[i].bounces.size());
    EXPECT_EQ(alone.bounces.back().point, together[i].bounces.back().point);
    EXPECT_EQ(alone.out, together[i].out);
  }
}

// pi (A + n A') / (P + (1 + n) P'): places and momenta are spread evenly.
TEST(GlassRooms, MeanFlightsAreThoseOfSantaloByMomenta) {
  for (const auto& [index, n] : {std::pair("1", 1.0), {"1.5", 1.5}, {"4", 4.0}, {"0.5", 0.5}}) {
    const double disc = kPiOfDiscs / 16;
    const Scene scene = disc_of(index);
    const ExperimentResult result = run("mean-free-path", {scene, 1, 200000, 1});
    const Measure mean = measure(result, "mean_free_path");
    ASSERT_TRUE(mean.standard_error && mean.expected);
    EXPECT_NEAR(*mean.expected, kPiOfDiscs * (1 + (n - 1) * disc) / (4 + (1 + n) * kPiOfDiscs / 2),
                1e-12);
    EXPECT_NEAR(mean.value, *mean.expected, 4 * *mean.standard_error) << index;
    EXPECT_LT(*mean.standard_error, 0.01 * mean.value);
    EXPECT_EQ(measure(result, "orbits_escaped").value, 0);
  }
}

TEST(GlassRooms, KeepTheSinesOfBouncesUniform) {
  const Scene scene = disc_of("1.8");
  const Measure square = measure(run("poincare", {scene, 3, 200000, 1}), "mean_square_sine");
  ASSERT_TRUE(square.standard_error && square.expected);
  EXPECT_NEAR(square.value, *square.expected, 4 * *square.standard_error);
}

// A share of all bounces is on each side of the glass, as its lengths times index are of all walls', and as many go in
// as out: of each orbit a sample.
TEST(GlassRooms, GoInAsOftenAsOutAndMeetEachSideByItsMomenta) {
  const Scene scene = disc_of("1.5");
  const Room rooms(scene);
  RatioSums inside, outside, in;
  for (const Orbit& orbit : trace_orbits(rooms.orbits(), drawn_starts(rooms, 2, 4000), 50)) {
    double met_inside = 0, met_outside = 0, balance = 0;
    for (const Bounce& one : orbit.bounces) {
      if (rooms.materials()[one.surface] != Material::glass) continue;
      const bool from_inside = one.normal.dot(one.point - Vec2(0.5, 0.5)) < 0;
      (from_inside ? met_inside : met_outside) += 1;
      if (one.is_refracted()) balance += from_inside ? -1 : 1;
    }
    const auto all = static_cast<double>(orbit.bounces.size());
    inside.add(met_inside, all);
    outside.add(met_outside, all);
    in.add(balance, all);
  }
  const double weight = 4 + 2.5 * kPiOfDiscs / 2;
  EXPECT_NEAR(inside.ratio(), 1.5 * kPiOfDiscs / 2 / weight, 4 * inside.standard_error());
  EXPECT_NEAR(outside.ratio(), kPiOfDiscs / 2 / weight, 4 * outside.standard_error());
  EXPECT_NEAR(in.ratio(), 0, 4 * in.standard_error());
  EXPECT_LT(inside.standard_error(), 0.02 * inside.ratio());
}

TEST(GlassRooms, TangentsAreNeighbours) {
  constexpr double kApart = 1e-7;
  const Scene scene = disc_of("1.5");
  const Room rooms(scene);
  const Vec2 from(0.13, 0.31), way(0.8, 0.6), left(-0.6, 0.8);
  int refracted = 0;
  for (std::uint64_t chance = 0; chance < 12; ++chance)
    for (const double turned : {0.0, 1.0}) {  // apart, or at an angle
      const double angle = turned * kApart;
      const Orbit one = orbit_of(rooms, {from, way}, 6, chance);
      const Orbit other = orbit_of(
          rooms,
          {from + (1 - turned) * kApart * left, std::cos(angle) * way + std::sin(angle) * left}, 6,
          chance);
      Tangent tangent{1 - turned, turned};
      for (std::size_t i = 0; i < std::min(one.bounces.size(), other.bounces.size()); ++i) {
        const Bounce &a = one.bounces[i], &b = other.bounces[i];
        if (a.surface != b.surface || a.is_refracted() != b.is_refracted()) break;
        const double bend = curvature(rooms.walls(), a.surface, a.point, a.normal);
        const double cosine = std::fabs(a.in.dot(a.normal));
        tangent.fly(a.t);
        if (a.is_refracted())
          tangent.refract(*refraction(rooms.index_ratio(a), cosine), bend), ++refracted;
        else
          tangent.reflect(2 * bend / cosine);
        const double size = std::hypot(tangent.q, tangent.p);
        EXPECT_NEAR(cross(a.out, b.point - a.point) / kApart, tangent.q, 1e-4 * size * size);
        EXPECT_NEAR(cross(a.out, b.out) / kApart, tangent.p, 1e-4 * size * size);
      }
    }
  EXPECT_GT(refracted, 20);
}

TEST(GlassRooms, OfIndexOneHaveNoExponent) {
  const ExperimentResult none = run("lyapunov", {.scene = disc_of("1"), .count = 40000});
  for (const Measure& one : none.measures) EXPECT_NE(one.name, "per_length");
  const Scene glass = disc_of("1.5");
  EXPECT_GT(measure(run("lyapunov", {.scene = glass, .count = 40000}), "per_length").value, 0.1);
}

// Almost all is reflected outside, and what is inside stays there: the room is that of a mirror.
TEST(GlassRooms, OfALargeIndexAreNearlyThoseOfMirrors) {
  const Scene scene = disc_of("100");
  EXPECT_NEAR(reflected_share(Room(scene), {{0.1, 0.5}, {1, 0}}, 20000), std::pow(99. / 101, 2),
              0.01);
}

TEST(GlassRooms, HaveNoPrecisionToChoose) {
  const Scene scene = disc_of("1.5");
  const Choice* precision = entry_named(choices(), "precision");
  if (precision == nullptr) GTEST_SKIP() << "no choice of precision";
  EXPECT_EQ(precision->left_out(scene), "glass splits its orbits");
}

}  // namespace
}  // namespace flatray
