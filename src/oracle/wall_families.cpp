#include "geom/polygon.h"
#include "oracle/families.h"

namespace flatray::oracle {
namespace {

using Scene = AimedScene;
using Ring = std::vector<Vec2>;
constexpr int kSide = 4, kCell = kWorld / kSide;
static_assert(kSide * kSide == kPolygonsAScene);

// Rings, each of which is drawn by its number.
template <class Make>
Scene rings(int count, const Make& make) {
  Scene scene;
  for (int i = 0; i < count; ++i)
    for (const Segment& wall : ring_edges(make(i))) scene.walls.push_back(wall);
  return scene;
}

// A ring of whole coordinates in each cell, of any shape: tracers see segments.
Scene grid_walls(Draw& draw) {
  return rings(kPolygonsAScene, [&](int cell) {
    Ring ring;
    for (int i = 0, n = draw.whole(3, 7); i < n; ++i)
      ring.push_back(Vec2(kCell * (cell % kSide), kCell * (cell / kSide)) +
                     draw.whole_point(0, kCell));
    return ring;
  });
}

Ray grid_ray(const Scene&, Draw& draw) {
  const Vec2 origin = draw.whole_point(-2, kWorld + 2);
  return {origin, draw.whole_point(-8, 9)};
}

Ray at_vertex(const Scene& scene, Draw& draw) {
  const Vec2 origin = draw.whole_point(-2, kWorld + 2);
  return {origin, draw.any(scene.walls).a - origin};
}

Ray at_vertex_or_grid(const Scene& scene, Draw& draw) {
  return draw.unit() < 0.5 ? at_vertex(scene, draw) : grid_ray(scene, draw);
}

Ray along_edge(const Scene& scene, Draw& draw) {
  const Segment& wall = draw.any(scene.walls);
  const Vec2 along = wall.b - wall.a;
  const double back = draw.below(4);
  return {wall.a - back * along, draw.sign() * along};
}

Ray one_ulp_off(const Scene& scene, Draw& draw) {
  const Ray ray = at_vertex(scene, draw);
  const Vec2 origin = nudge(ray.origin, draw);
  return {origin, nudge(ray.direction, draw)};
}

Ray near_parallel(const Scene& scene, Draw& draw) {
  const Segment& wall = draw.any(scene.walls);
  const Vec2 e = wall.b - wall.a;
  const double tilt = draw.signed_halves(60);
  return {wall.a - e, e + tilt * Vec2(-e.y(), e.x())};
}

Ray without_direction(const Scene& scene, Draw& draw) {
  const Segment& wall = draw.any(scene.walls);
  const double at = draw.below(3);
  if (at == 2) return {draw.whole_point(0, kWorld), {0, 0}};
  return {wall.a + at * 0.5 * (wall.b - wall.a), {0, 0}};
}

Scene mixed_magnitude(Draw& draw) {
  return rings(kPolygonsAScene, [&](int) {
    Ring ring;
    for (int k = 0; k < 3; ++k) {
      const Vec2 place{2 * draw.unit() - 1, 2 * draw.unit() - 1};
      ring.push_back(draw.power(-100, 100) * place);
    }
    return ring;
  });
}

Ray from_corner_to_corner(const Scene& scene, Draw& draw) {
  const Vec2 from = draw.any(scene.walls).a, along{draw.sign(), draw.unit()};
  const Vec2 origin = from + draw.power(-100, 100) * along;
  return {origin, draw.any(scene.walls).b - origin};
}

// Points, repeated walls and walls on one line.
Scene degenerate(Draw& draw) {
  return rings(kPolygonsAScene, [&](int) {
    const Vec2 a = draw.whole_point(0, kWorld), step = draw.whole_point(-1, 2);
    Ring ring;
    for (int k = 0, n = draw.whole(1, 5); k < n; ++k) ring.push_back(a + draw.below(4) * step);
    return ring;
  });
}

Scene random_triangles(Draw& draw) {
  return rings(kPolygonsAScene, [&](int) {
    const Vec2 a = draw.point();
    return Ring{a, a + 0.25 * draw.point(), a - 0.25 * draw.point()};
  });
}

Ray random_ray(const Scene&, Draw& draw) {
  const Vec2 origin = 2 * draw.point() - Vec2(0.5, 0.5);
  return {origin, draw.point() - Vec2(0.5, 0.5)};
}

// Points of a parabola closed by its chord are convex whatever their number.
Scene many_gons(Draw& draw) {
  return rings(kPolygonsAScene / 4, [&](int i) {
    const Vec2 corner(2.0 * i, draw.below(3));
    Ring ring;
    for (int k = 0, n = draw.whole(3, 33); k < n; ++k)
      ring.push_back(corner + Vec2(k / 32.0, k * k / 1024.0));
    return ring;
  });
}

Ray at_many_gon(const Scene& scene, Draw& draw) {
  const Vec2 origin{9 * draw.unit() - 1, 4 * draw.unit() - 1};
  const Vec2 way = draw.any(scene.walls).a - origin;
  return {origin, draw.unit() < 0.5 ? way : nudge(way, draw)};
}

template <int exponent>
Move units(Draw&) {
  return {[](const Vec2& v) { return Vec2(v * std::ldexp(1.0, exponent)); }};
}
Move tenths(Draw&) {
  return {[](const Vec2& v) { return Vec2(v / 10); }};
}
Move far_away(Draw& draw) { return moved_by({0x1p52 * draw.sign(), 0x1p52 * draw.sign()}); }
Move thin(Draw& draw) { return flattened(draw.halves(1060)); }

}  // namespace

std::vector<Family> wall_families() {
  return {
      {"grid", "everything on whole numbers: ends, ties and overlaps abound", &grid_walls,
       &grid_ray},
      {"vertex", "rays at ends of walls", &grid_walls, &at_vertex},
      {"edge", "rays along walls", &grid_walls, &along_edge},
      {"one-ulp", "rays an ulp off the ends of walls", &grid_walls, &one_ulp_off},
      {"decimal", "tenths, which doubles do not hold", &grid_walls, &at_vertex_or_grid, &tenths},
      {"near-parallel", "rays tilted against walls by 1 to 2^-59", &grid_walls, &near_parallel},
      {"denormal", "in units of the smallest double", &grid_walls, &at_vertex_or_grid,
       &units<-1074>},
      {"huge", "in units of 2^1017", &grid_walls, &at_vertex_or_grid, &units<1017>},
      {"scaled", "in units of 2^-900 to 2^899", &grid_walls, &at_vertex_or_grid, &scaled},
      {"offset", "moved by 2^52, where doubles are whole numbers", &grid_walls, &at_vertex_or_grid,
       &far_away},
      {"sliver", "flattened by up to 2^-1059", &grid_walls, &at_vertex_or_grid, &thin},
      {"mixed-magnitude", "every corner of a size of its own, 2^-100 to 2^99", &mixed_magnitude,
       &from_corner_to_corner},
      {"degenerate", "points, repeated walls, walls on one line", &degenerate, &at_vertex_or_grid},
      {"zero-length", "rays without direction: what does the origin lie on", &grid_walls,
       &without_direction},
      {"random", "uniform doubles", &random_triangles, &random_ray},
      {"n-gon", "polygons of up to 32 corners", &many_gons, &at_many_gon},
  };
}

}  // namespace flatray::oracle
