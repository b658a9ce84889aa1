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
  Hash straight, curved;
  for (const Family& family : families())
    for (std::uint64_t item = 0; item < 8; ++item) {
      const AimedScene scene = make_scene(family, 1, item);
      if (!scene.beziers.empty()) continue;  // see bezier_test.cpp
      Hash& hash = scene.curves.empty() ? straight : curved;
      for (const Segment& wall : scene.walls) add(hash, wall.a), add(hash, wall.b);
      for (const Ray& ray : scene.rays) add(hash, ray.origin), add(hash, ray.direction);
      for (const Arc& arc : scene.curves)
        for (const Vec2& v : {arc.curve.centre, arc.curve.u, arc.curve.v, arc.from, arc.to})
          add(hash, v);
    }
  EXPECT_EQ(straight.hex(), "b29511bd8bb84e63");
  EXPECT_EQ(curved.hex(), "3e9d46e9d47bd936");
}

}  // namespace
}  // namespace flatray::oracle
