#include "oracle/moving_pairs.h"

#include <gtest/gtest.h>

#include <bit>

#include "base/hash.h"
#include "oracle/turning_pairs.h"

namespace flatray::oracle {
namespace {

void put(Hash& hash, double x) { hash.add(std::bit_cast<std::uint64_t>(x)); }
void put(Hash& hash, const Vec2& v) { put(hash, v.x()), put(hash, v.y()); }
void put(Hash& hash, const std::vector<Vec2>& ring) {
  hash.add(ring.size());
  for (const Vec2& p : ring) put(hash, p);
}

void put(Hash& hash, const StraightPair& pair) {
  put(hash, pair.ring_a), put(hash, pair.ring_b);
  put(hash, pair.velocity_a), put(hash, pair.velocity_b);
  if (pair.radius_a > 0 || pair.radius_b > 0) put(hash, pair.radius_a), put(hash, pair.radius_b);
}
void put(Hash& hash, const TurningPair& pair) {
  for (const TurningCore& core : {pair.a, pair.b}) {
    put(hash, core.ring);
    for (const double x : {core.radius, core.angle, core.spin}) put(hash, x);
    put(hash, core.at), put(hash, core.velocity);
  }
}

// A line for each family: its name and the hash of its first pairs.
template <class Families>
std::string first_pairs(const Families& families) {
  std::string lines;
  for (const auto& family : families) {
    Hash hash;
    for (std::uint64_t item = 0; item < 64; ++item) put(hash, make_pair(family, 1, item));
    lines += std::string(family.name) + ' ' + hash.hex() + '\n';
  }
  return lines;
}

// What is found of a pair is told by its number: that names one pair.
TEST(MovingPairs, AreTheSameForEveryCompiler) {
  EXPECT_EQ(first_pairs(straight_families()),
            "grid 56a892604faf8a29\n"
            "degenerate f1483a83e18fd971\n"
            "decimal 386d457da4cebcad\n"
            "one-ulp cd7b65933a93a09a\n"
            "scaled 024e35f50f22e080\n"
            "offset 8e220148bad071ca\n"
            "near-parallel 8083caeb94e67c55\n"
            "mixed-magnitude 5305c3782044e0cf\n"
            "sliver 60058fae77b1a5e7\n"
            "uneven 8cd00a36338c7c0d\n"
            "touching ada237ec21df804a\n");
  EXPECT_EQ(first_pairs(round_families()),
            "round-whole b77ccb55ec7c2fe3\n"
            "round-tangent 82aa81e1ff6e4d0d\n"
            "round-decimal 5cfda0dfbb9a9a83\n"
            "round-scaled dd0e35cc2ef25251\n"
            "round-one-ulp 28b4905452bfc1db\n");
}

TEST(TurningPairs, AreTheSameForEveryCompiler) {
  EXPECT_EQ(first_pairs(turning_families()),
            "turning-polygons 8f047b7220391064\n"
            "turning-rounded 90e0b4f85c8227a4\n"
            "turning-slivers 7feb3d64c964ad43\n"
            "turning-segments b3007e558b0b5f47\n"
            "turning-fast f73e7347c014c00c\n"
            "turning-far 0e7cfe376916b81f\n"
            "turning-squares 8b96174cbfcf004d\n"
            "turning-grazing 0be77c36e63ab7ba\n");
}

}  // namespace
}  // namespace flatray::oracle
