// needs: shapes/box shapes/circle lamps/point lamps/ray materials/diffuse materials/mirror materials/mix materials/isotropic materials/pass materials/glass passes/light formats/toml
// How far light is from the truth, and rounds of rays in any order.
#include "render/light/light_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "render/light/light_picture.h"
#include "render/lit.h"

namespace flatray {
namespace {

// A room with a lamp and a matt disc, on 16 by 16 pixels.
Scene small_room(const std::string& light) {
  return scene_of(
      "flatray = 1\nfilm = { size = [16, 16], world = [[-4, -4], [4, 4]] }\n[light]\n" + light +
      "\n[[lamp]]\nsource = { point = {} }\nat = [-2, 1]\n"
      "[[chamber]]\nshape = { box = { min = [-3.5, -3.5], max = [3.5, 3.5] } }\n"
      "material = { diffuse = { reflectance = 0.5 } }\n"
      "[[entity]]\nshape = { circle = { radius = 1 } }\nat = [1, 0]\nmaterial = 'mirror'\n");
}

std::vector<std::vector<std::int64_t>> sums(const TracedLight& light) {
  std::vector<std::vector<std::int64_t>> all;
  for (const LightFilm& film : light.films)
    all.push_back(in_three_channels(film.sums(), film.channels()));
  return all;
}

void expect_same(const TracedLight& a, const TracedLight& b) {
  EXPECT_EQ(sums(a), sums(b));
  EXPECT_EQ(a.rounds, b.rounds);
  EXPECT_EQ(a.lines(), b.lines());
  EXPECT_EQ(a.counts.emitted, b.counts.emitted);
  EXPECT_EQ(a.counts.absorbed, b.counts.absorbed);
  EXPECT_EQ(a.unit(), b.unit());
}

TEST(LightRounds, AreTheSameForAnyThreads) {
  const Scene scene = small_room("rays = 20000\nscrambles = 16");
  const TracedLight one = traced(scene);
  EXPECT_EQ(one.films.size(), 16U);
  EXPECT_EQ(one.counts.rays, 20000U);
  for (const unsigned threads : {2U, 7U}) expect_same(traced(scene, {}, {}, 0, threads), one);
}

// Two rounds in one go; one and then the other; each by itself, the last first.
TEST(LightRounds, AddUpInAnyOrder) {
  const Scene two = small_room("rays = 524288\nscrambles = 16\nbounces = 0");
  const Scene one = small_room("rays = 262144\nscrambles = 16\nbounces = 0");
  const TracedLight all = traced(two);
  EXPECT_EQ(all.rounds.count(), 2U);
  expect_same(traced(two, {}, traced(one)), all);
  TracedLight light;
  for (const std::uint64_t shard : {1U, 0U})
    light = traced(two, {.shard = shard, .shards = 2}, std::move(light));
  expect_same(light, all);
}

TEST(LightRounds, OfTheFirstScrambleAreThoseWithoutScrambles) {
  const TracedLight plain = traced(small_room("rays = 1000"));
  const TracedLight scrambled = traced(small_room("rays = 16000\nscrambles = 16"));
  EXPECT_EQ(scrambled.films[0].sums(), plain.films[0].sums());
  EXPECT_NE(scrambled.films[1].sums(), plain.films[0].sums());
  EXPECT_EQ(scrambled.film_unit(), plain.unit());
}

// A lamp that is off makes no light, but it could have a colour.
TEST(LightRounds, OfGreyLightHaveOneChannelAndTheSameSums) {
  const auto with = [](const char* colour) {
    return small_room("rays = 20000\n[[lamp]]\nsource = { point = {} }\npower = 0\ncolour = '" +
                      std::string(colour) + "'\n");
  };
  const Scene grey = with("#ffffff"), could_be = with("#ff8000");
  const TracedLight one = traced(grey), three = traced(could_be);
  EXPECT_EQ(one.films[0].channels(), 1);
  EXPECT_EQ(three.films[0].channels(), 3);
  EXPECT_EQ(one.sums(), three.sums());
  EXPECT_EQ(one.unit(), three.unit());
}

TEST(LightRounds, OfWhatCouldBeColouredHaveThreeChannels) {
  const auto channels = [](const std::string& more) {
    return light_channels(scene_of("flatray = 1\n[[lamp]]\nsource = { point = {} }\n" + more));
  };
  const std::string disc = "[[entity]]\nshape = { circle = { radius = 1 } }\nmaterial = ";
  EXPECT_EQ(channels(""), 1);
  EXPECT_EQ(channels("colour = '#808080'"), 1);
  EXPECT_EQ(channels("colour = '#808081'"), 3);
  EXPECT_EQ(channels("nm = 500"), 3);
  EXPECT_EQ(channels("kelvin = 6500"), 3);
  EXPECT_EQ(channels("colour = { keys = [[0, '#000000'], [1, '#ff0000']] }"), 3);
  for (const char* kind : {"diffuse", "mirror", "mix", "isotropic", "pass"}) {
    const std::string material = "{ " + std::string(kind) + " = { colour = '#";
    EXPECT_EQ(channels(disc + material + "999999' } }"), 1) << kind;
    EXPECT_EQ(channels(disc + material + "999998' } }"), 3) << kind;
  }
  EXPECT_EQ(channels(disc + "{ glass = {} }"), 1);
  EXPECT_EQ(channels(disc + "{ glass = { dispersion = 4200 } }"), 3);
}

TEST(LightGoals, EndWhereTheErrorIsSmallEnough) {
  const Scene scene = small_room("rays = 26214400\nscrambles = 16\nbounces = 2");
  std::vector<double> errors;
  LightGoal goal{.error = 0.0035};
  goal.told = [&](const TracedLight&, std::optional<double> error) {
    ASSERT_TRUE(error.has_value());
    errors.push_back(*error);
  };
  const TracedLight light = traced(scene, goal);
  ASSERT_FALSE(errors.empty());
  EXPECT_EQ(errors.size(), light.rounds.count());
  EXPECT_LE(errors.back(), 0.0035);
  for (std::size_t i = 0; i + 1 < errors.size(); ++i) EXPECT_GT(errors[i], 0.0035);
  EXPECT_EQ(report_of(light).error, errors.back());
}

TEST(LightGoals, OfTimeHaveOneRoundAtLeast) {
  const Scene scene = small_room("rays = 1000000000000\nbounces = 2");
  EXPECT_EQ(traced(scene, {.seconds = 1e-9}).rounds.count(), 1U);
}

// Without a light to be seen no error is small: all rays that are asked for are traced.
TEST(LightGoals, AreNotReachedInTheDark) {
  const Scene scene = scene_of(
      "flatray = 1\nfilm = { size = [4, 4], world = [[-4, -4], [4, 4]] }\n[light]\nrays = 600000\n"
      "scrambles = 16\n[[lamp]]\nsource = { ray = {} }\nat = [9, 9]\n");
  LightGoal told;
  told.told = [](const TracedLight&, std::optional<double>) {};
  EXPECT_EQ(traced(scene, told).rounds.count(), 3U);
  told.error = 0.1;
  EXPECT_EQ(traced(scene, told).rounds.count(), 3U);
}

// In the dark an error that is asked for is waited for in eight rounds; who asks for none has them all.
TEST(LightGoals, OfNoErrorAreAllRoundsInTheDarkToo) {
  const Scene scene = scene_of(
      "flatray = 1\nfilm = { size = [4, 4], world = [[-4, -4], [4, 4]] }\n[light]\nrays = 2500000\n"
      "scrambles = 16\n[[lamp]]\nsource = { ray = {} }\nat = [9, 9]\n");
  LightGoal told;
  told.told = [](const TracedLight&, std::optional<double>) {};
  EXPECT_EQ(traced(scene, told).rounds.count(), 10U);
  told.error = 0.1;
  EXPECT_EQ(traced(scene, told).rounds.count(), 8U);
}

TEST(LightErrors, AreThoseOfStudent) {
  // Means 8.5 and spreads of 1 to 16: the variance of the mean is 17 * 16 / 12 / 16.
  std::vector<std::vector<std::int64_t>> scrambles;
  for (std::int64_t k = 1; k <= 16; ++k) scrambles.push_back({k << 20, k << 20, k << 20, 1, 1, 1});
  const double error = std::sqrt(17.0 * 16 / 12 / 16);
  EXPECT_NEAR(relative_error(scrambles).value(), error / 8.5, 1e-6);
  const LinearImage image = error_image(scrambles, 0x1p-20, 2, 1);
  EXPECT_NEAR(static_cast<double>(image.pixels[0]), 2.1314495 * error, 1e-5);
  EXPECT_TRUE(std::isnan(image.pixels[3]));  // sixteen units are less than a hundred rays
  const Image shown = shown_error(scrambles, 2, 1);
  EXPECT_EQ(shown.at(0, 0)[3], 255);
  EXPECT_EQ(shown.at(1, 0)[3], 0);
}

TEST(LightErrors, OfDarknessAreNone) {
  const std::vector<std::vector<std::int64_t>> dark(16, std::vector<std::int64_t>(12));
  EXPECT_EQ(relative_error(dark), std::nullopt);
}

// Mean of 1 / (2 pi r) over the pixel that is `side` wide.
double mean_over_pixel(const Vec2& centre, double side) {
  constexpr int kSteps = 32;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < kSteps; ++j) {
      const Vec2 at = centre + side * Vec2((i + 0.5) / kSteps - 0.5, (j + 0.5) / kSteps - 0.5);
      sum += 1 / (2 * std::numbers::pi * std::sqrt(at.squaredNorm()));
    }
  return sum / (kSteps * kSteps);
}

// Of 200 pictures, pixels whose interval holds the truth, and those that have an interval.
std::pair<std::size_t, std::size_t> covered(const char* sampler) {
  const Scene scene = scene_of(
      "flatray = 1\nfilm = { size = [8, 8], world = [[-4, -4], [4, 4]] }\n[light]\nrays = 8192\n"
      "scrambles = 16\nsampler = '" +
      std::string(sampler) + "'\n[[lamp]]\nsource = { point = {} }\n");
  std::vector<double> truth;
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) truth.push_back(mean_over_pixel({x - 3.5, 3.5 - y}, 1));
  std::size_t held = 0, all = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const TracedLight light = traced(scene, {}, {}, seed);
    const LinearImage half = error_image(sums(light), light.film_unit(), 8, 8);
    const std::vector<std::int64_t> total = light.sums();
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const double far = std::sqrt(
          Vec2(static_cast<double>(i % 8) - 3.5, 3.5 - static_cast<double>(i / 8)).squaredNorm());
      if (far < 1.5 || std::isnan(half.pixels[3 * i])) continue;  // the quadrature is not exact
      const double mean = static_cast<double>(total[3 * i]) * light.unit();
      held += std::abs(mean - truth[i]) <= static_cast<double>(half.pixels[3 * i]) ? 1 : 0;
      ++all;
    }
  }
  return {held, all};
}

TEST(LightErrors, IntervalsHoldTheTruthAsOftenAsTheySay) {
  for (const char* sampler : {"sorted", "random"}) {
    const auto [held, all] = covered(sampler);
    EXPECT_GT(all, 200U * 40);
    const double share = static_cast<double>(held) / static_cast<double>(all);
    EXPECT_GE(share, 0.93) << sampler;
    EXPECT_LE(share, 0.97) << sampler;
  }
}

// Where every lamp is off there is nothing to trace, and still an end to ask for.
TEST(LightRounds, OfDarknessEndWhereTheyAreStopped) {
  const Scene scene = scene_of(
      "flatray = 1\nfilm = { size = [4, 4], world = [[-1, -1], [1, 1]] }\n"
      "light = { rays = 1000000000000 }\n[[lamp]]\nsource = { point = {} }\n"
      "power = { keys = [[0, 0], [1, 1]] }\n");
  const Timeline timeline(scene, 0, 1);
  const TracedLight light =
      trace_frame_light(scene, at(timeline, 1), nullptr, 0, 1, [] { return true; });
  EXPECT_FALSE(light.whole);
  EXPECT_EQ(light.rounds.count(), 0U);
}

TEST(LightRounds, AreCountedOnce) {
  FilmRounds rounds, more;
  for (const std::uint64_t round : {3U, 3U, 200U}) rounds.add(round);
  EXPECT_EQ(rounds.count(), 2U);
  for (const std::uint64_t round : {3U, 64U}) more.add(round);
  rounds.add(more);
  EXPECT_EQ(rounds.count(), 3U);
  EXPECT_EQ(FilmRounds(rounds.words()).count(), 3U);
}

// All worlds of alternatives are in memory at once.
TEST(LightMemory, HasTheWallsOfAllAlternatives) {
  const auto bytes = [](const std::string& alternatives) {
    const std::string segment = "{ segment = { from = [0, 0], to = [1, 0] } }";
    std::string all;
    for (int i = 0; i < 63; ++i) all += segment + ",";
    return light_bytes(
        scene_of(
            "flatray = 1\nfilm = { size = [4, 4], world = [[-1, -1], [1, 1]] }\n"
            "light = { rays = 1 }\n[[lamp]]\nsource = { point = {} }\n[[entity]]\nshape = " +
            segment +
            "\nmaterial = 'absorb'\nrepeat = { grid = { count = [1000, 1], step = [1, 1] } }\n" +
            (alternatives.empty() ? "" : "alternatives = [" + all + "]\n")),
        1);
  };
  EXPECT_GT(bytes("64"), bytes("") + 63 * 1000 * 200);
}

}  // namespace
}  // namespace flatray
