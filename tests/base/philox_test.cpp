#include "base/philox.h"

#include <gtest/gtest.h>

namespace flatray {
namespace {

using Counter = std::array<std::uint32_t, 4>;

// Random123's published known answers for philox4x32 with 10 rounds (its file kat_vectors).
TEST(Philox, MeetsItsPublishedKnownAnswers) {
  EXPECT_EQ(philox4x32({0, 0, 0, 0}, {0, 0}),
            (Counter{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  constexpr std::uint32_t f = 0xffffffff;
  EXPECT_EQ(philox4x32({f, f, f, f}, {f, f}),
            (Counter{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox4x32({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Counter{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Philox, EveryPartOfADrawsNameChangesIt) {
  const std::uint64_t draw = random_bits(1, Stream::test, 2, 3, 4);
  EXPECT_NE(draw, random_bits(2, Stream::test, 2, 3, 4));
  EXPECT_NE(draw, random_bits(1, Stream::markov, 2, 3, 4));
  EXPECT_NE(draw, random_bits(1, Stream::test, 3, 3, 4));
  EXPECT_NE(draw, random_bits(1, Stream::test, 2, 4, 4));
  EXPECT_NE(draw, random_bits(1, Stream::test, 2, 3, 5));
}

TEST(Philox, UnitDoubleStaysBelowOne) {
  EXPECT_EQ(unit_double(0), 0.0);
  EXPECT_EQ(unit_double(~std::uint64_t{0}), 1.0 - 0x1p-53);
}

}  // namespace
}  // namespace flatray
