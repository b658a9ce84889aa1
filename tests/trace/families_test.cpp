// Rays of the adversarial families, in batches and one by one.
#include "oracle/families.h"

#include <gtest/gtest.h>

#include "full_counts.h"
#include "trace/all_tracers.h"

namespace flatray {
namespace {

// By number, as scenes are drawn.
class Families : public testing::TestWithParam<std::size_t> {
 protected:
  const oracle::Family& family() const { return oracle::families()[GetParam()]; }
  // Of families of many kinds of walls and rays, more.
  std::uint64_t scenes() const {
    const std::string name = family().name;
    return times(1000, name == "round-mixed" || name == "axes" ? 30 : 6);
  }
};

// Rays of Bezier curves take ms: every run affords few.
Case case_of(const oracle::Family& family, std::uint64_t seed, std::uint64_t item) {
  const oracle::AimedScene scene = oracle::make_scene(family, seed, item);
  Case c{scene.surfaces(), {}};
  for (const Ray& ray : scene.rays)
    if (at_full_counts() || scene.beziers.empty() || c.rays.size() < 8) c.rays.add(ray);
  return c;
}

TEST_P(Families, EveryWayToAskGivesTheExactHit) {
  for (std::uint64_t item = 0; item < scenes(); ++item) {
    expect_all_tiers_exact(case_of(family(), 1, item));
    if (HasFatalFailure()) FAIL() << family().name << ", item " << item;
  }
}

// What a ray meets first is then what it has departed, in that root or another.
TEST_P(Families, WhatIsDepartedIsPassedByInEveryWay) {
  for (std::uint64_t item = 0; item < scenes(); ++item) {
    Case c = case_of(family(), 2, item);
    c.rays.tangents = item % 2 == 0;
    for (std::uint32_t i = 0; i < c.rays.size(); ++i) {
      const NearestHit first = exact_hit_of(c, i);
      const std::array roots = {first.root, Root::first, Root::second, Root::both};
      if (first) c.rays.departed[i] = {first.surface, roots[i % 4]};
    }
    expect_all_tiers_exact(c);
    if (HasFatalFailure()) FAIL() << family().name << ", item " << item;
  }
}

INSTANTIATE_TEST_SUITE_P(Tracers, Families,
                         testing::Range<std::size_t>(0, oracle::families().size()),
                         [](const auto& each) {
                           std::string name = oracle::families()[each.param].name;
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace flatray
