// Rays of the adversarial families, in batches and one by one.
#include "oracle/families.h"

#include <gtest/gtest.h>

#include "full_counts.h"
#include "trace/all_tracers.h"

namespace flatray {
namespace {

class Families : public testing::TestWithParam<oracle::Family> {};

TEST_P(Families, EveryWayToAskGivesTheExactHit) {
  for (std::uint64_t item = 0; item < times(1000, 5); ++item) {
    const oracle::AimedScene scene = oracle::make_scene(GetParam(), 1, item);
    Case c{scene.surfaces(), {}};
    for (const Ray& ray : scene.rays) c.rays.add(ray);
    expect_all_tiers_exact(c);
    if (HasFatalFailure()) FAIL() << GetParam().name << ", item " << item;
  }
}
INSTANTIATE_TEST_SUITE_P(Tracers, Families, testing::ValuesIn(oracle::wall_families()),
                         [](const auto& each) {
                           std::string name = each.param.name;
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace flatray
