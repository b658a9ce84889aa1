// The numbers that light is spread by.
#include <gtest/gtest.h>

#include <set>

#include "transport/light/light_ray.h"
#include "transport/light/net.h"
#include "transport/light/order.h"

namespace flatray {
namespace {

TEST(LightNet, HasOneNumberInEachPart) {
  for (const std::uint32_t seed : {0U, 1U, 0xdeadbeefU})
    for (unsigned dimension = 0; dimension < kMostNetDimensions; ++dimension)
      for (const std::uint32_t count : {2U, 16U, 1024U}) {
        std::set<int> parts;
        for (std::uint32_t i = 0; i < count; ++i) {
          const double u = net_number(i + 3 * count, dimension, seed);
          ASSERT_TRUE(u >= 0 && u < 1);
          parts.insert(static_cast<int>(u * count));
        }
        EXPECT_EQ(parts.size(), count) << seed << " " << dimension;
      }
}

// A (0, 2) sequence: every elementary rectangle of area 1 / 256 holds one of 256 points.
TEST(LightNet, IsANetInItsFirstTwoDimensions) {
  for (const std::uint32_t seed : {5U, 77U})
    for (unsigned wide = 0; wide <= 8; ++wide) {
      std::set<int> boxes;
      for (std::uint32_t i = 0; i < 256; ++i) {
        const auto x = static_cast<int>(net_number(i, 0, seed) * (1 << wide));
        const auto y = static_cast<int>(net_number(i, 1, seed + 9) * (1 << (8 - wide)));
        boxes.insert(x * 256 + y);
      }
      EXPECT_EQ(boxes.size(), 256U) << wide;
    }
}

TEST(LightNet, SeedsGiveOtherNumbers) {
  int same = 0;
  for (std::uint32_t i = 0; i < 1000; ++i)
    same += net_number(i, 0, 1) == net_number(i, 0, 2) ? 1 : 0;
  EXPECT_LT(same, 3);
}

TEST(LightOrder, IsStableAndAscending) {
  const std::vector<WallPlace> places = {7, 1ULL << 40, 7, 0, ~0ULL, 256, 7};
  EXPECT_EQ(ascending_order(places), (std::vector<std::uint32_t>{3, 0, 2, 6, 5, 1, 4}));
  EXPECT_TRUE(ascending_order({}).empty());
}

TEST(Media, AreTheSameInWhateverOrderTheyAreEntered) {
  Media media;
  for (const std::uint32_t body : {7U, 4U, 5U}) media.enter(body);
  EXPECT_EQ(media.around(Media::kNone), 7U);
  EXPECT_EQ(media.around(7), 5U);
  media.leave(7);
  EXPECT_EQ(media.around(5), 4U);
}

TEST(Media, KnowTheInnermostAroundABody) {
  Media media;
  EXPECT_EQ(media.around(0), Media::kNone);
  media.enter(4);
  media.enter(7);
  EXPECT_EQ(media.around(7), 4U);
  EXPECT_EQ(media.around(4), 7U);
  media.leave(4);
  EXPECT_EQ(media.around(7), Media::kNone);
  media.leave(7);
  for (std::uint32_t body = 10; body < 18; ++body) media.enter(body);
  EXPECT_FALSE(media.forgets());
  media.enter(18), media.enter(9), media.enter(19);
  EXPECT_TRUE(media.forgets());
  EXPECT_EQ(media.around(19), 18U);
  for (std::uint32_t body = 12; body < 20; ++body) media.leave(body);
  EXPECT_EQ(media.around(0), Media::kNone);
}

}  // namespace
}  // namespace flatray
