// needs: shapes/box shapes/circle shapes/capsule experiments/escape experiments/recurrence experiments/splitting
// Rooms that orbits leave by holes, or by gaps between what they bounce off.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "study/chamber_scenes.h"
#include "study/rooms/conditional_starts.h"
#include "study/statistics/estimate.h"

namespace flatray {
namespace {

using namespace flatray::testing;

constexpr double kHalfCircle = 3.14159265358979324;

// Of starts by the measure that reflection keeps the holes' share of the walls leaves at the first wall.
TEST(Escape, TakesTheHolesShareAtTheFirstWall) {
  for (const Starts starts : {Starts::random, Starts::quasi}) {
    const Scene scene = with_holes("capsule = { from = [-1, 0], to = [1, 0], radius = 1 }",
                                   "{ edge = 0, from = 0.2, to = 0.3, name = \"a\" }, { edge = 3, "
                                   "from = 0.5, to = 0.6, name = \"b\" }");
    const auto found = run("escape", {.scene = scene,
                                      .count = 10'000,
                                      .bounces = 300,
                                      .starts = starts,
                                      .precision = OrbitPrecision::fast});
    const Measure first = measure(found, "leaves_at_first_wall");
    EXPECT_NEAR(*first.expected, (0.1 * kHalfCircle + 0.1 * 2) / (4 + 2 * kHalfCircle), 1e-9);
    EXPECT_TRUE(agrees(first)) << first.value << " " << *first.expected;
    EXPECT_TRUE(found.holds);
    EXPECT_GT(measure(found, "leaves_by a").value, measure(found, "leaves_by b").value);
  }
}

// Of the 16 pixels of a box the 4 on its diagonal run into its corner, along it: no wall took them. An
// exit without a name is known by its line.
TEST(Escape, TellsCornersFromWalls) {
  const std::string box =
      "film = { size = [4, 4], world = [[0, 0], [4, 4]] }\n[[ray]]\nat = [1, 1]\ndirection = [1, "
      "1]\n"
      "[[chamber]]\nshape = { box = { min = [0, 0], max = [4, 4] } }\n";
  const auto escape = [](const Scene& scene) {
    return run("escape", {.scene = scene, .count = 100, .bounces = 50, .map = PixelMap::position});
  };
  const Scene mirrors = scene_of(box), dark = scene_of(box + "material = \"absorb\"\n");
  const auto found = escape(mirrors);
  EXPECT_EQ(found.measures.front().name, "into the open");
  EXPECT_EQ(measure(found, "into a corner").value, 0.25);
  EXPECT_EQ(measure(found, "trapped").value, 0.75);
  EXPECT_EQ(escape(dark).measures.front().name, "into chamber 1");
}

// A circle with a hole of angle e: of orbits that turn by nearly 2 pi m / q a bounce what is left after n
// bounces comes to n P(n) = sum over q < 2 pi / e, m prime to q, of sin(pi m / q) q / (8 pi) (2 pi / q - e)^2,
// by areas in the plane of place and turn; by length 2 / e as e goes to 0 (Bunimovich and Dettmann 2005).
TEST(Escape, FromACircleFallsLikeItsClosedForm) {
  const double hole = 2 * kHalfCircle * 0.08;
  double expected = 0;
  for (int q = 2; q * hole < 2 * kHalfCircle; ++q)
    for (int m = 1; m < q; ++m)
      if (std::gcd(m, q) == 1)
        expected += std::sin(kHalfCircle * m / q) * q / (8 * kHalfCircle) *
                    std::pow(2 * kHalfCircle / q - hole, 2);
  const Scene scene = with_holes("circle = { radius = 1 }", "{ from = 0.3, to = 0.38 }");
  const Room room(scene);
  class Count : public OrbitSink {
   public:
    void bounce(std::size_t, const Bounce&) override {}
    void end(std::size_t, const OrbitStop& stop) override { left += stop.end == OrbitEnd::limit; }
    int left = 0;
  } count;
  constexpr int kOrbits = 60'000, kBounces = 400;
  std::vector<OrbitStart> starts;
  for (std::uint64_t i = 0; i < kOrbits; ++i) starts.push_back(room.draw_start(1, i));
  room.fast_orbits().follow(starts, kBounces, count);
  const double share = static_cast<double>(count.left) / kOrbits;
  const double error = kBounces * std::sqrt(share / kOrbits);
  EXPECT_NEAR(kBounces * share, expected, 4 * error);
  EXPECT_LT(error, 0.06 * expected);  // so that it can fail
}

// Kac: whatever the room, what sets off from the holes is back after P / h arrivals and a way of pi A / h in
// the mean.
TEST(Recurrence, IsBackByKacsLemma) {
  const Scene box = with_holes("box = { min = [0, 0], max = [1, 1] }",
                               "{ edge = 0, from = 0.3, to = 0.5 }, { edge = 2, from = 0, to = "
                               "0.2 }");
  // A disc that nearly fills a triangle leaves no orbit between parallel walls.
  const Scene triangle = scene_of(
      "[[chamber]]\nshape = { polygon = { points = [[0, 0], [1, 0], [0.35, 0.8]] } }\n"
      "pillars = [{ shape = { circle = { centre = [0.42, 0.275], radius = 0.25 } } }]\n"
      "holes = [{ edge = 0, from = 0.2, to = 0.6 }]\n");
  const auto found = run("recurrence", {.scene = triangle, .count = 20'000});
  const Measure arrivals = measure(found, "mean_arrivals"), way = measure(found, "mean_way");
  const double walls = 1 + std::sqrt(0.65 * 0.65 + 0.64) + std::sqrt(0.35 * 0.35 + 0.64);
  EXPECT_NEAR(*arrivals.expected, (walls + 0.5 * kHalfCircle) / 0.4, 1e-9);
  EXPECT_NEAR(*way.expected, kHalfCircle * (0.4 - 0.0625 * kHalfCircle) / 0.4, 1e-9);
  ASSERT_TRUE(arrivals.standard_error.has_value()) << arrivals.remark;
  EXPECT_TRUE(agrees(arrivals)) << arrivals.value;
  EXPECT_TRUE(agrees(way)) << way.value;
  // Orbits of a square come back, too, but some of them late: there is no error, and the mean is near.
  const auto of_box = run("recurrence", {.scene = box, .count = 20'000});
  EXPECT_NEAR(measure(of_box, "mean_arrivals").expected.value_or(0), 10, 1e-9);
  EXPECT_FALSE(measure(of_box, "mean_arrivals").standard_error.has_value());
  EXPECT_NEAR(measure(of_box, "mean_arrivals").value, 10, 1);
}

Scene three_discs_six_apart() {
  return scene_of("film = { size = [4, 4] }\n" + three_discs_6_apart());
}

// Rates of three discs 6 apart by cycle expansion (experiment periodic).
constexpr double kRateByBounce = 1.6981063230203446, kRateByLength = 0.4103384077693465;

// Of those that are left before any bounce the same share leaves at it, from the first one on; of starts by
// the measure that reflection keeps more leave at the first, as at no other.
TEST(ConditionalStarts, LeaveExponentiallyFromTheFirstBounceOn) {
  const Scene scene = three_discs_six_apart();
  const Room room(scene);
  const ExperimentContext context{.scene = scene,
                                  .count = 160'000,
                                  .threads = 2,
                                  .starts = Starts::conditional,
                                  .precision = OrbitPrecision::fast};
  const auto starts = ConditionalStarts::draw(context, room, 1000);
  ASSERT_TRUE(starts.has_value()) << format(starts.error());
  const auto orbits = trace_outcomes(context, room, 1000, context.count, 0,
                                     [&](std::uint64_t i) { return (*starts)[i]; });
  for (std::uint32_t n = 0; n < 4; ++n) {
    StartSums leaving(Starts::conditional);
    for (std::size_t i = 0; i < orbits->size(); ++i)
      if ((*orbits)[i].bounces >= n) leaving.add(i, (*orbits)[i].bounces == n ? 1 : 0, 1);
    const Measure share = leaving.all().measure("leaves", 1 - std::exp(-kRateByBounce));
    EXPECT_EQ(share.freedom, kShifts - 1);
    EXPECT_TRUE(agrees(share)) << n << ": " << share.value << " +- " << *share.standard_error;
    EXPECT_LT(*share.standard_error, 0.01 * std::exp(0.9 * n)) << n;  // so that it can fail
  }
}

TEST(ConditionalStarts, GiveTheRatesOfEscape) {
  const Scene scene = three_discs_six_apart();
  ExperimentContext context{.scene = scene,
                            .count = 160'000,
                            .threads = 2,
                            .starts = Starts::conditional,
                            .precision = OrbitPrecision::fast};
  const auto found = run("escape", context);
  const Measure by_bounce = measure(found, "escape_rate_per_bounce"),
                by_length = measure(found, "escape_rate_per_length");
  EXPECT_TRUE(has(by_bounce.remark, "from bounce 0 to"));
  EXPECT_NEAR(by_bounce.value, kRateByBounce, 4 * *by_bounce.standard_error);
  EXPECT_NEAR(by_length.value, kRateByLength, 4 * *by_length.standard_error);
  EXPECT_LT(*by_bounce.standard_error, 0.04);
  context.threads = 1;
  EXPECT_EQ(run("escape", context).files.front().content, found.files.front().content);
  EXPECT_LT(*by_length.standard_error, 0.02);
}

// What is left of a circle falls like a power; a closed room leaves nothing to tell a law of.
TEST(ConditionalStarts, AreRefusedWhereOrbitsDoNotLeaveExponentially) {
  const Scene circle = with_holes("circle = { radius = 1 }", "{ from = 0.3, to = 0.38 }"),
              closed = stadium();
  const auto refused = [](const Scene& scene, std::uint64_t count, std::uint64_t bounces) {
    const auto found = experiment("escape").run({.scene = scene,
                                                 .count = count,
                                                 .bounces = bounces,
                                                 .starts = Starts::conditional,
                                                 .precision = OrbitPrecision::fast});
    return found ? "" : found.error().front().message;
  };
  EXPECT_TRUE(has(refused(circle, 60'000, 400), "(n + 1)^-"));
  EXPECT_TRUE(has(refused(closed, 4000, 50), "cannot be told"));
  EXPECT_TRUE(has(refused(circle, 3000, 50), "32 groups of 94 orbits"));
}

// Three discs 6 apart (Gaspard and Rice 1989 have a rate of 0.4103 by length), far beyond what is left of as many orbits without splitting.
TEST(Splitting, MeasuresWhatAPlainEnsembleDoesNotSee) {
  const Scene scene = three_discs_six_apart();
  int within = 0;
  constexpr int kSeeds = 3;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const auto found = run("splitting", {.scene = scene,
                                         .seed = seed,
                                         .count = 2'000'000,
                                         .bounces = 11,
                                         .apart = 0.025 * std::exp2(seed),  // whichever it is
                                         .precision = OrbitPrecision::fast});
    const Measure by_length = measure(found, "escape_rate_per_length"),
                  by_bounce = measure(found, "escape_rate_per_bounce");
    ASSERT_TRUE(by_length.standard_error && by_bounce.standard_error) << by_length.remark;
    EXPECT_NEAR(by_length.value, kRateByLength, 4 * *by_length.standard_error);
    EXPECT_NEAR(by_bounce.value, kRateByBounce, 4 * *by_bounce.standard_error);
    EXPECT_LT(*by_bounce.standard_error, 0.03);
    within += std::fabs(by_bounce.value - kRateByBounce) <= *half_interval(by_bounce);
    const double left = found.measures.front().value,
                 followed = measure(found, "orbits_followed").value;
    EXPECT_LT(left * followed, 0.01);
  }
  EXPECT_GE(within, kSeeds - 2);
}

}  // namespace
}  // namespace flatray
