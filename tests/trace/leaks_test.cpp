// Sealed rooms: whatever a ray inside is aimed at, and most of all a vertex, it meets a wall.
#include <gtest/gtest.h>

#include "trace/random_rays.h"
#include "trace/tracer.h"

namespace flatray {
namespace {

struct Place {
  double scale;
  Vec2 offset;
};

class RoomAt : public testing::TestWithParam<Place> {};

// A convex room of many short walls with pillars in it.
Surfaces sealed_room(Draws& draw, int corners, int pillars, const Place& place) {
  Surfaces walls;
  const auto add_ring = [&](const Vec2& centre, double radius, int count) {
    std::vector<Vec2> ring;
    for (int i = 0; i < count; ++i) {
      const double turn = 6.283185307179586 * i / count;
      ring.push_back(place.scale * (centre + radius * Vec2(std::cos(turn), std::sin(turn))) +
                     place.offset);
    }
    for (std::size_t i = 0; i < ring.size(); ++i)
      walls.add(Segment{ring[i], ring[(i + 1) % ring.size()]});
  };
  add_ring({0, 0}, 1, corners);
  for (int i = 0; i < pillars; ++i)
    add_ring(0.6 * (2 * draw.point() - Vec2(1, 1)), 0.01 + 0.04 * draw.unit(), 3 + i % 6);
  return walls;
}

TEST_P(RoomAt, NothingLeaksAtVertices) {
  constexpr std::size_t kRays = 25'000;
  constexpr int kCorners = 300;
  Draws draw(1);
  const Place& place = GetParam();
  const Surfaces walls = sealed_room(draw, kCorners, 60, place);
  RayBatch rays;
  std::vector<bool> at_room;  // else at a pillar, past whose corner a rounded direction may go
  while (rays.size() < kRays) {
    const Vec2 inside = 0.65 * (2 * draw.point() - Vec2(1, 1));
    const std::size_t wall = draw.bits() % walls.segments.size();
    const Segment& aim = walls.segments[wall];
    at_room.push_back(wall < kCorners);
    const Vec2 from = place.scale * inside + place.offset;
    rays.add({from, aim.a - from});
  }
  for (const Tracer* tracer : tracers()) {
    if (!tracer->exact) continue;
    std::vector<NearestHit> hits(rays.size());
    tracer->build(walls)->nearest(rays, hits);
    std::size_t leaks = 0;
    for (std::size_t i = 0; i < hits.size(); ++i)
      if (!hits[i] || (at_room[i] && !(hits[i].t < 1 + 0x1p-40))) ++leaks;
    EXPECT_EQ(leaks, 0U) << tracer->name;
  }
}

INSTANTIATE_TEST_SUITE_P(EveryPlace, RoomAt,
                         testing::Values(Place{1, {0, 0}}, Place{1, {1e6, -1e6}},
                                         Place{1e-5, {0, 0}}, Place{1e15, {0, 0}}));

}  // namespace
}  // namespace flatray
