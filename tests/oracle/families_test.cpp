#include "oracle/families.h"

#include <gtest/gtest.h>

#include <bit>

#include "base/hash.h"

namespace flatray::oracle {
namespace {

void add(Hash& hash, const Vec2& v) {
  hash.add(std::bit_cast<std::uint64_t>(v.x())).add(std::bit_cast<std::uint64_t>(v.y()));
}

// Rows of `flatray stability` are compared with those of other builds: a number names one scene.
TEST(Families, AreTheSameForEveryCompiler) {
  Hash hash;
  for (const Family& family : families())
    for (std::uint64_t item = 0; item < 8; ++item) {
      const AimedScene scene = make_scene(family, 1, item);
      for (const Segment& wall : scene.walls) add(hash, wall.a), add(hash, wall.b);
      for (const Ray& ray : scene.rays) add(hash, ray.origin), add(hash, ray.direction);
    }
  EXPECT_EQ(hash.hex(), "b29511bd8bb84e63");
}

}  // namespace
}  // namespace flatray::oracle
