#include "transport/exact_origin.h"

#include <gtest/gtest.h>

#include "trace/crowd.h"

namespace flatray {
namespace {

TEST(ExactOrigins, AtTheEndsOfManyWallsAreThoseOfEachWallAskedAlone) {
  Draws draw(3);
  Surfaces walls = crowd(draw, 500, 0.3);
  for (int i = 0; i < 500; ++i) {
    const Vec2 at = draw.point();
    walls.add(Circle{at, 0.1 * draw.unit()});
  }
  const ExactOrigins origins(walls);
  for (int i = 0; i < 200; ++i) {
    const Vec2 end = walls.segments[draw.bits() % walls.segments.size()].a;
    std::vector<std::uint32_t> met;
    for (std::uint32_t wall = 0; wall < walls.size(); ++wall) {
      Surfaces alone;
      walls.visit(wall, [&](const auto& each) { alone.add(each); });
      if (!ExactOrigins(alone).walls_at(end).empty()) met.push_back(wall);
    }
    EXPECT_EQ(origins.walls_at(end), met);
  }
}

}  // namespace
}  // namespace flatray
