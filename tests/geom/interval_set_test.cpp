#include "geom/interval_set.h"

#include <gtest/gtest.h>

#include "geom/clip_cases.h"

namespace flatray {
namespace {

std::vector<std::pair<double, double>> pairs(const IntervalSet& set) {
  std::vector<std::pair<double, double>> all;
  for (const Range& part : set) all.emplace_back(part.low, part.high);
  return all;
}
using Pairs = std::vector<std::pair<double, double>>;

TEST(IntervalSet, PartsThatOverlapOrTouchBecomeOne) {
  EXPECT_EQ(pairs(interval_set({{5, 6}, {0, 2}, {1, 3}, {3, 4}, {9, 8}})), (Pairs{{0, 4}, {5, 6}}));
}

TEST(IntervalSet, APointIsAPart) {
  EXPECT_EQ(pairs(interval_set({{1, 1}, {1, 1}})), (Pairs{{1, 1}}));
  EXPECT_EQ(pairs(intersection_of(IntervalSet{{0, 1}}, IntervalSet{{1, 2}})), (Pairs{{1, 1}}));
}

TEST(IntervalSet, ADifferenceKeepsTheEndsOfWhatIsTakenOut) {
  const IntervalSet a = {{0, 10}};
  EXPECT_EQ(pairs(difference_of(a, IntervalSet{{2, 3}, {5, 5}})), (Pairs{{0, 2}, {3, 10}}));
  EXPECT_EQ(pairs(difference_of(a, IntervalSet{{-1, 4}, {9, 12}})), (Pairs{{4, 9}}));
  EXPECT_TRUE(difference_of(a, IntervalSet{{0, 10}}).empty());
  EXPECT_TRUE(difference_of(IntervalSet{{1, 1}}, IntervalSet{{0, 2}}).empty());
}

TEST(IntervalSet, AWholeLineHasNoEnds) {
  const IntervalSet line = {kLine}, ray = {kRay};
  EXPECT_EQ(pairs(intersection_of(line, ray)), (Pairs{{0, kInfinity}}));
  EXPECT_EQ(pairs(difference_of(line, ray)), (Pairs{{-kInfinity, 0}}));
  EXPECT_EQ(length_of(ray), kInfinity);
}

bool holds(const IntervalSet& set, double t) {
  return std::any_of(set.begin(), set.end(),
                     [&](const Range& part) { return part.low <= t && t <= part.high; });
}

// At numbers between the ends, sets are truth tables.
TEST(IntervalSet, OperationsAreThoseOfTruthBetweenTheEnds) {
  for (std::uint64_t item = 0; item < 300; ++item) {
    Draw draw(kSeed, 80, item);
    const auto random_set = [&] {
      std::vector<Range> parts;
      for (int i = 0; i < 4; ++i) {
        const double low = draw.below(20);
        parts.push_back({low, low + draw.below(6)});
      }
      return interval_set(parts);
    };
    const IntervalSet a = random_set(), b = random_set();
    const IntervalSet sum = union_of(a, b), shared = intersection_of(a, b);
    const IntervalSet rest = difference_of(a, b);
    for (double t = -0.5; t < 27; ++t) {
      EXPECT_EQ(holds(sum, t), holds(a, t) || holds(b, t));
      EXPECT_EQ(holds(shared, t), holds(a, t) && holds(b, t));
      EXPECT_EQ(holds(rest, t), holds(a, t) && !holds(b, t));
    }
    EXPECT_EQ(length_of(sum) + length_of(shared), length_of(a) + length_of(b));
    EXPECT_EQ(length_of(rest) + length_of(shared), length_of(a));
  }
}

}  // namespace
}  // namespace flatray
