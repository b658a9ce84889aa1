// needs: shapes/box shapes/circle shapes/capsule shapes/ellipse experiments/mean_free_path experiments/lyapunov experiments/poincare
#include "study/rooms/followed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "precise/certified_orbit.h"
#include "study/chamber_scenes.h"
#include "study/statistics/estimate.h"

namespace flatray {
namespace {

using namespace flatray::testing;

ExperimentContext fast(const Scene& scene, std::uint64_t count) {
  ExperimentContext context{scene, 1, count};
  context.precision = OrbitPrecision::fast;
  return context;
}

TEST(FastExperiments, AgreeWithClosedFormsAndExactOnesAndPassTheirAudit) {
  for (const Scene& scene : {sinai("0.25"), stadium(), room("ellipse = { radii = [3, 2] }")}) {
    const ExperimentResult quick = run("mean-free-path", fast(scene, 16'000));
    EXPECT_TRUE(quick.holds) << quick.summary;
    const Measure path = measure(quick, "mean_free_path");
    EXPECT_NEAR(path.value, *path.expected, 4 * *path.standard_error);
    EXPECT_EQ(measure(quick, "orbits_escaped").value, 0);
    ExperimentContext again = fast(scene, 16'000);
    again.threads = 3;
    EXPECT_EQ(run("mean-free-path", again).summary, quick.summary);
    if (!can_certify()) continue;
    EXPECT_EQ(measure(quick, "audit_parted_at_once").value, 0);
    EXPECT_GT(measure(quick, "audit_bounces_right_fast").value, 12);
    EXPECT_NEAR(measure(quick, "audit_bounces_right_fast").value,
                measure(quick, "audit_bounces_right_exact").value, 3);
  }
}

TEST(FastExperiments, FindTheExponentThatExactOnesFind) {
  const Scene scene = sinai("0.25");
  const Measure quick = measure(run("lyapunov", fast(scene, 30'000)), "per_length");
  const Measure exact = measure(run("lyapunov", {scene, 2, 30'000}), "per_length");
  EXPECT_NEAR(quick.value, exact.value,
              4 * std::hypot(*quick.standard_error, *exact.standard_error));
}

// A disc larger by 1e-7: first flights then end elsewhere, and the audit says so.
TEST(FastExperiments, HaveAnAuditThatSeesOrbitsOfAnotherRoom) {
  if (!can_certify()) GTEST_SKIP() << "no module of certified orbits";
  const Scene scene = sinai("0.25");
  const Room room(scene);
  const ExperimentContext context = fast(scene, 1000);
  const std::vector<OrbitStart> starts = audited_starts(
      context, 16, [&](std::uint64_t i) { return room.draw_start(context.seed, i); });
  const std::vector<Measure> right = audit(context, room, starts, 40);
  EXPECT_TRUE(std::all_of(right.begin(), right.end(), &agrees));
  const Scene larger = sinai("0.2500001");
  const Room other(larger);
  const std::vector<Measure> wrong = audit_of(other.fast_orbits(), context, room, starts, 40);
  EXPECT_FALSE(std::all_of(wrong.begin(), wrong.end(), &agrees));
}

TEST(FastExperiments, FollowCertifiedOrbitsAsFarAsTheyAreProven) {
  if (!can_certify()) GTEST_SKIP() << "no module of certified orbits";
  const Scene scene = sinai("0.25");
  ExperimentContext context{scene, 1, 400};
  context.bounces = 10;
  const Measure exact = measure(run("mean-free-path", context), "mean_free_path");
  context.precision = OrbitPrecision::certified;
  EXPECT_NEAR(measure(run("mean-free-path", context), "mean_free_path").value, exact.value, 1e-6);
}

// A disc so small that doubles come to another cell after some bounces: of orbits in other cells nothing is
// alike, though each is on the same disc, and they are farther apart than a cell is wide.
TEST(Divergence, OfATorusTellsCellsApart) {
  const Scene scene = scene_of(
      "[[chamber]]\nmaterial = \"periodic\"\nshape = { box = { min = [0, 0], max = [1, 1] } }\n"
      "pillars = [{ shape = { circle = { centre = [0.5, 0.5], radius = 0.002 } } }]\n"
      "[[ray]]\nname = \"r\"\nat = [0.1, 0.15]\ndirection = [0.7312, -0.4411]\n");
  const auto result = experiment("divergence").run({.scene = scene, .bounces = 6});
  if (is_unavailable(result)) GTEST_SKIP() << "no certified orbits in this build";
  for (const char* what :
       {"r: doubles within 1 % of the room until bounce", "r: walls of doubles right until bounce",
        "r: bounces of doubles proven"})
    EXPECT_EQ(measure(*result, what).value, 3) << what;
  std::istringstream rows(content_of(*result, "divergence_bounces.csv"));
  std::string orbit, bounce, apart, rest;
  double most = 0;
  for (std::getline(rows, rest); std::getline(rows, orbit, ','); std::getline(rows, rest)) {
    std::getline(std::getline(rows, bounce, ','), apart, ',');
    most = std::max(most, std::stod(apart));
  }
  EXPECT_GT(most, 10);
}

// Long flights round by more than 64 units of the cell.
TEST(Audit, AllowsLongFlightsOfATorusTheirRounding) {
  const ExperimentResult fast = run(
      "mean-free-path",
      {.scene = torus("0.01"), .count = 2'000, .bounces = 20, .precision = OrbitPrecision::fast});
  EXPECT_TRUE(fast.holds) << fast.summary;
}

}  // namespace
}  // namespace flatray
