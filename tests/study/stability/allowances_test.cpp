// needs: shapes/box shapes/circle
// What study lets pass as rounding, held against truth from outside: an allowance a milliard times as large
// lets something pass here that is wrong.
#include <gtest/gtest.h>

#include <cmath>

#include "collide/turning_contact.h"
#include "oracle/turning_pairs.h"
#include "study/chamber_scenes.h"
#include "study/spoiled_tracer.h"
#include "study/stability/leaks.h"
#include "study/stability/pair_stability.h"
#include "study/stability/scale_sweep.h"
#include "study/statistics/estimate.h"

namespace flatray {
namespace {

using namespace flatray::testing;

TEST(Allowances, OfSumsAreRoundingAlone) {
  EXPECT_TRUE(agrees({"m", 1 + 1e-13, 0, 1}));
  EXPECT_FALSE(agrees({"m", 1 + 1e-10, 0, 1}));
  EXPECT_FALSE(agrees({"m", 1 + 1e-10, {}, 1, kInfinity, 0}));
  EXPECT_TRUE(agrees({"m", 2, {}, 1})) << "nothing can be said";
  EXPECT_EQ(verdict({"m", 2, {}, 1}), std::nullopt);
}

// The box and what flies in it; the discs `a` and `b` lie in each other by a part of the radius.
std::string gas(double overlap) {
  return fmt::format(
      "[[entity]]\nshape = {{ box = {{ min = [-9, -9], max = [-8, 9] }} }}\n"
      "[[entity]]\nshape = {{ box = {{ min = [8, -9], max = [9, 9] }} }}\n"
      "[[entity]]\nname = \"a\"\nshape = {{ circle = {{ radius = 1 }} }}\nat = [-2, 3]\n"
      "velocity = [1e-13, 0]\n"
      "[[entity]]\nname = \"b\"\nshape = {{ circle = {{ radius = 1 }} }}\nat = [{:.17g}, 3]\n"
      "velocity = [-1e-13, 0]\n"
      "[[entity]]\nshape = {{ circle = {{ radius = 1 }} }}\nat = [0, -3]\nvelocity = [7, 0]\n",
      -overlap);
}

TEST(Allowances, OfAGasAreFarBelowWhatIsWrong) {
  const ExperimentResult apart = run("gas", {.scene = scene_of(gas(-0.5)), .count = 1000});
  EXPECT_TRUE(apart.holds) << apart.summary;
  const Measure energy = measure(apart, "energy_off"), depth = measure(apart, "deepest_overlap");
  EXPECT_LE(std::fabs(energy.value), *energy.allowed);
  EXPECT_LT(*energy.allowed, 1e-11);
  EXPECT_LT(*depth.allowed, 1e-11);
  const ExperimentResult within = run("gas", {.scene = scene_of(gas(1e-7)), .count = 1000});
  EXPECT_FALSE(within.holds) << within.summary;
  EXPECT_NEAR(measure(within, "deepest_overlap").value, 1e-7 / 9, 1e-9);
}

TEST(Gas, WhatIsNotMeasuredHasNoError) {
  for (const Measure& one : run("gas", {.scene = scene_of(gas(-0.5)), .count = 500}).measures) {
    EXPECT_FALSE(one.standard_error) << one.name;
    EXPECT_FALSE(half_interval(one)) << one.name;
  }
}

// In a circle the distance of the first line from the centre is sqrt(5)/4 for this ray, all along it.
TEST(Allowances, OfACausticAreFarBelowWhatIsSeen) {
  const Scene scene = scene_of(
      "film = { size = [32, 32] }\n[[chamber]]\nshape = { circle = { radius = 1 } }\n"
      "[[ray]]\nname = \"r\"\nat = [0.5, 0.25]\ndirection = [-1, 2]\n");
  for (const char* name : {"r: nearest line to the middle", "r: farthest line"}) {
    const Measure found = measure(run("caustic", {scene}), name);
    EXPECT_LE(std::fabs(found.value - std::sqrt(5.0) / 4), *found.allowed) << name;
    EXPECT_LT(*found.allowed, 1e-10);
    EXPECT_FALSE(found.standard_error);
  }
}

// Finds the walls of the room alone, as if no pillar stood in it.
class Pillarless final : public Accelerator {
 public:
  explicit Pillarless(const Surfaces& walls) : Accelerator(walls) {
    for (std::size_t i = 0; i < 300; ++i) room_.add(walls.segments[i]);
    right_ = find_tracer("brute")->build(room_);
  }
  void nearest(const RayBatch& rays, std::span<NearestHit> hits) const override {
    RayBatch free;
    for (std::size_t i = 0; i < rays.size(); ++i)
      free.add(rays.ray(i), rays.departed[i].surface < 300 ? rays.departed[i] : DepartedSurface{});
    right_->nearest(free, hits);
  }
  std::size_t bytes() const override { return right_->bytes(); }

 private:
  Surfaces room_;
  std::unique_ptr<Accelerator> right_;
};
std::unique_ptr<Accelerator> build_pillarless(const Surfaces& walls, Isa, unsigned) {
  return std::make_unique<Pillarless>(walls);
}

TEST(Allowances, OfFloatsAreNotForWhatFliesThroughPillars) {
  const Tracer pillarless = {"pillarless", "", false, &build_pillarless};
  const LeakTally tally = count_leaks(pillarless, room_places().front(), 1, 0);
  EXPECT_GT(tally.through, tally.asked / 20);
  EXPECT_GT(tally.through, 5 * tally.through_end);
}

// Every t some ulps too large.
template <int ulps>
void make_late(std::span<NearestHit> hits) {
  for (NearestHit& hit : hits)
    for (int i = 0; hit && i < ulps; ++i) hit.t = std::nextafter(hit.t, kInfinity);
}

TEST(Allowances, OfSweepsAreOneUlp) {
  const Tracer exact = spoiled_by<&make_late<0>>(), late = spoiled_by<&make_late<3>>();
  const Tracer* const both[] = {&exact, &late};
  const SweepCell cell = sweep_cell(both, 3, 0, 0);
  EXPECT_EQ(cell.off[0], 0U);
  EXPECT_GT(cell.off[1], cell.rays / 2);
  EXPECT_EQ(cell.wrong[1], 0U);
}

// Pairs that meet are told to some 1e-12 of a frame, by bisection in 256 bits.
TEST(Allowances, OfTurningPairsAreFarBelowAFrame) {
  int told = 0;
  for (const oracle::TurningFamily& family : oracle::turning_families()) {
    const oracle::TurningPair pair = oracle::make_pair(family, 1, 1);
    const auto body = [](const oracle::TurningCore& core) {
      return TurningBody{core.ring, core.radius,
                         even_motion(core.at, core.velocity, core.angle, core.spin)};
    };
    const oracle::FirstTouch truth = oracle::first_touch(pair.a, pair.b, 1);
    const TurningContact met = turning_contact(body(pair.a), body(pair.b), 1, kAskedWidth);
    if (truth.kind != oracle::FirstTouch::Kind::touch ||
        met.first.high - met.first.low > kAskedWidth)
      continue;
    ++told;
    EXPECT_LT(met.first.high - truth.low, 2e-12) << family.name;
    EXPECT_LT(truth.high - met.first.low, 2e-12) << family.name;
  }
  EXPECT_GT(told, 1);
}

}  // namespace
}  // namespace flatray
