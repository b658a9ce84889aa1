#include "study/stability/stability.h"

#include <gtest/gtest.h>

#include "study/spoiled_tracer.h"

namespace flatray {
namespace {

template <void (*spoil)(NearestHit&)>
void spoil_all(std::span<NearestHit> hits) {
  for (NearestHit& hit : hits)
    if (hit) spoil(hit);
}
void change_nothing(NearestHit&) {}
void one_wall_up(NearestHit& hit) { ++hit.surface; }
void one_ulp_up(NearestHit& hit) { hit.t = std::nextafter(hit.t, kInfinity); }
void three_ulps_up(NearestHit& hit) {
  for (int i = 0; i < 3; ++i) one_ulp_up(hit);
}
void miss(NearestHit& hit) { hit = {}; }

template <void (*spoil)(NearestHit&)>
StabilityTally tally_of() {
  const Tracer tracer = testing::spoiled_by<&spoil_all<spoil>>();
  const TracerInTier spoiled[] = {{&tracer}};
  return check_rays(spoiled, oracle::families()[0], 1, 0, 3 * oracle::kRaysAScene).front();
}

TEST(Stability, TellsRightFromWrong) {
  const StabilityTally right = tally_of<&change_nothing>();
  EXPECT_EQ(right.rays, 3U * oracle::kRaysAScene);
  EXPECT_GT(right.hits, 50U);
  EXPECT_EQ(right.wrong, 0U);
  EXPECT_EQ(right.not_nearest, 0U);
  EXPECT_TRUE(right.first_wrong.empty());
  EXPECT_EQ(tally_of<&one_wall_up>().wrong, right.hits);
  EXPECT_EQ(tally_of<&miss>().wrong, right.hits);
  const StabilityTally off = tally_of<&one_ulp_up>();
  EXPECT_EQ(off.wrong, 0U);
  EXPECT_EQ(off.not_nearest, right.hits);
  EXPECT_EQ(off.off_by_more, 0U);
  EXPECT_EQ(tally_of<&three_ulps_up>().off_by_more, right.hits);
  EXPECT_EQ(right.worst_ulps, 0U);
  EXPECT_EQ(off.worst_ulps, 1U);
  EXPECT_EQ(tally_of<&three_ulps_up>().worst_ulps, 3U);
  EXPECT_EQ(right.timed, right.rays);
  EXPECT_GT(right.objects, 0U);
}

TEST(StabilityTally, OneHitInAThousandMayBeFartherOffThanMost) {
  StabilityTally tally;
  tally.hits = 2000;
  tally.worst_ulps = 70'000;
  tally.off_by_more = 900;
  tally.off_by_far = {500, 2, 0, 0, 0, 0};
  EXPECT_EQ(tally.most_ulps(), 65'536U);
  tally.off_by_far[0] = 2;
  EXPECT_EQ(tally.most_ulps(), 256U);
  tally.off_by_more = 2;
  EXPECT_EQ(tally.most_ulps(), 1U);
  tally.off_by_more = 900;
  tally.off_by_far.fill(900);
  EXPECT_EQ(tally.most_ulps(), 70'000U);
}

// Also within a scene: what comes before a ray and what comes from it on are all there is.
TEST(Stability, FewerRaysAreTheFirstOfMore) {
  const Tracer tracer = testing::spoiled_by<&spoil_all<&miss>>();
  const TracerInTier spoiled[] = {{&tracer}};
  const auto check = [&](std::uint64_t first, std::uint64_t count) {
    return check_rays(spoiled, oracle::families()[0], 1, first, count).front();
  };
  constexpr std::uint64_t kScene = oracle::kRaysAScene;
  for (const std::uint64_t count : {1U, 63U, 64U, 65U, 200U}) {
    EXPECT_EQ(check(0, count).rays, count);
    EXPECT_EQ(check(0, kScene + count).missed,
              check(0, kScene).missed + check(kScene, count).missed);
  }
}

TEST(Stability, EveryExactTracerIsRightInEveryFamily) {
  std::vector<TracerInTier> exact;
  for (const Tracer* tracer : tracers())
    for (const Isa isa : available_isas())
      if (tracer->exact) exact.push_back({tracer, isa});
  for (const oracle::Family& family : oracle::families()) {
    const std::vector<StabilityTally> tallies =
        check_rays(exact, family, 2, 0, 2 * oracle::kRaysAScene);
    for (std::size_t i = 0; i < exact.size(); ++i) {
      const StabilityTally& tally = tallies[i];
      EXPECT_EQ(tally.wrong, 0U) << exact[i].tracer->name << ", " << family.name << ", "
                                 << tally.first_wrong;
      EXPECT_EQ(tally.off_by_more, 0U) << exact[i].tracer->name << ", " << family.name;
      EXPECT_LE(100 * tally.not_nearest, tally.hits)
          << exact[i].tracer->name << ", " << family.name;
    }
  }
}

}  // namespace
}  // namespace flatray
