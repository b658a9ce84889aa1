#include "oracle/families.h"

#include <limits>
#include <utility>

#include "oracle/bezier_families.h"
#include "oracle/round_families.h"

namespace flatray::oracle {
namespace {

constexpr int kSide = 4, kCell = 8, kWorld = kSide * kCell;
static_assert(kSide * kSide == kPolygonsAScene);

Vec2 grid_point(Draw& draw, int low, int high) {
  const double x = low + draw.below(high - low);
  return {x, low + draw.below(high - low)};
}

void add_ring(AimedScene& scene, const std::vector<Vec2>& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    scene.walls.push_back({ring[i], ring[(i + 1) % ring.size()]});
}

// A ring of whole coordinates in each cell, of any shape: tracers see segments.
AimedScene grid_walls(Draw& draw) {
  AimedScene scene;
  for (int cell = 0; cell < kPolygonsAScene; ++cell) {
    const Vec2 corner(kCell * (cell % kSide), kCell * (cell / kSide));
    std::vector<Vec2> ring;
    for (int i = 0, n = 3 + static_cast<int>(draw.below(4)); i < n; ++i)
      ring.push_back(corner + grid_point(draw, 0, kCell));
    add_ring(scene, ring);
  }
  return scene;
}

const Segment& any_wall(const AimedScene& scene, Draw& draw) {
  return scene.walls[static_cast<std::size_t>(draw.below(static_cast<int>(scene.walls.size())))];
}

// Rays made one by one among walls that are there.
template <class Make>
AimedScene aimed(AimedScene scene, const Make& make) {
  for (int i = 0; i < kRaysAScene; ++i) scene.rays.push_back(make(scene));
  return scene;
}

Ray grid_ray(Draw& draw) {
  const Vec2 origin = grid_point(draw, -2, kWorld + 2);
  return {origin, grid_point(draw, -8, 9)};
}

AimedScene grid(Draw& draw) {
  return aimed(grid_walls(draw), [&](const AimedScene&) { return grid_ray(draw); });
}

Ray at_vertex(const AimedScene& scene, Draw& draw) {
  const Vec2 origin = grid_point(draw, -2, kWorld + 2);
  return {origin, any_wall(scene, draw).a - origin};
}

AimedScene vertex(Draw& draw) {
  return aimed(grid_walls(draw), [&](const AimedScene& scene) { return at_vertex(scene, draw); });
}

AimedScene edge(Draw& draw) {
  return aimed(grid_walls(draw), [&](const AimedScene& scene) {
    const Segment& wall = any_wall(scene, draw);
    const Vec2 along = wall.b - wall.a;
    const double back = draw.below(4);
    return Ray{wall.a - back * along, draw.sign() * along};
  });
}

AimedScene one_ulp(Draw& draw) {
  return aimed(grid_walls(draw), [&](const AimedScene& scene) {
    const Ray ray = at_vertex(scene, draw);
    const Vec2 origin = nudge(ray.origin, draw);
    return Ray{origin, nudge(ray.direction, draw)};
  });
}

AimedScene near_parallel(Draw& draw) {
  return aimed(grid_walls(draw), [&](const AimedScene& scene) {
    const Segment& wall = any_wall(scene, draw);
    const Vec2 e = wall.b - wall.a;
    const double sign = draw.sign(), tilt = std::ldexp(sign, -static_cast<int>(draw.below(60)));
    return Ray{wall.a - e, e + tilt * Vec2(-e.y(), e.x())};
  });
}

// A scene with every point put through f; rays keep the points they lead to.
template <class Move>
AimedScene mapped(AimedScene scene, const Move& f) {
  for (Segment& wall : scene.walls) wall = {f(wall.a), f(wall.b)};
  for (Ray& ray : scene.rays) {
    const Vec2 tip = f(ray.origin + ray.direction), origin = f(ray.origin);
    ray = {origin, tip - origin};
  }
  return scene;
}

// Half of the rays at vertices, half on the grid.
AimedScene mixed_rays(Draw& draw) {
  return aimed(grid_walls(draw), [&](const AimedScene& scene) {
    return draw.unit() < 0.5 ? at_vertex(scene, draw) : grid_ray(draw);
  });
}

AimedScene times(AimedScene scene, double factor) {
  return mapped(std::move(scene), [&](const Vec2& v) { return Vec2(v * factor); });
}

AimedScene decimal(Draw& draw) {
  return mapped(mixed_rays(draw), [](const Vec2& v) { return Vec2(v / 10); });
}
AimedScene denormal(Draw& draw) { return times(mixed_rays(draw), 5e-324); }
AimedScene huge(Draw& draw) { return times(mixed_rays(draw), 0x1p1017); }
AimedScene scaled(Draw& draw) {
  const int exponent = static_cast<int>(draw.below(1800)) - 900;
  return times(mixed_rays(draw), std::ldexp(1.0, exponent));
}
AimedScene offset(Draw& draw) {
  const double x = 0x1p52 * draw.sign();
  const Vec2 far(x, 0x1p52 * draw.sign());
  return mapped(mixed_rays(draw), [&](const Vec2& v) { return Vec2(v + far); });
}
AimedScene sliver(Draw& draw) {
  const double thin = std::ldexp(1.0, -static_cast<int>(draw.below(1060)));
  return mapped(mixed_rays(draw), [&](const Vec2& v) { return Vec2(v.x(), v.y() * thin); });
}

double magnitude(Draw& draw) { return std::ldexp(1.0, static_cast<int>(draw.below(200)) - 100); }

AimedScene mixed_magnitude(Draw& draw) {
  AimedScene scene;
  for (int i = 0; i < kPolygonsAScene; ++i) {
    std::vector<Vec2> ring;
    for (int k = 0; k < 3; ++k) {
      const Vec2 place{2 * draw.unit() - 1, 2 * draw.unit() - 1};
      ring.push_back(magnitude(draw) * place);
    }
    add_ring(scene, ring);
  }
  return aimed(std::move(scene), [&](const AimedScene& made) {
    const Vec2 from = any_wall(made, draw).a, along{draw.sign(), draw.unit()};
    const Vec2 origin = from + magnitude(draw) * along;
    const Vec2 to = any_wall(made, draw).b;
    return Ray{origin, to - origin};
  });
}

// Points, repeated walls and walls on one line.
AimedScene degenerate(Draw& draw) {
  AimedScene scene;
  for (int i = 0; i < kPolygonsAScene; ++i) {
    const Vec2 a = grid_point(draw, 0, kWorld);
    const Vec2 step = grid_point(draw, -1, 2);
    std::vector<Vec2> ring;
    for (int k = 0, n = 1 + static_cast<int>(draw.below(4)); k < n; ++k)
      ring.push_back(a + draw.below(4) * step);
    add_ring(scene, ring);
  }
  return aimed(std::move(scene), [&](const AimedScene& made) {
    return draw.unit() < 0.5 ? at_vertex(made, draw) : grid_ray(draw);
  });
}

AimedScene zero_length(Draw& draw) {
  return aimed(grid_walls(draw), [&](const AimedScene& scene) {
    const Segment& wall = any_wall(scene, draw);
    const double at = draw.below(3);
    const Vec2 on =
        at == 2 ? grid_point(draw, 0, kWorld) : Vec2(wall.a + at * 0.5 * (wall.b - wall.a));
    return Ray{on, {0, 0}};
  });
}

AimedScene random_scene(Draw& draw) {
  AimedScene scene;
  const auto point = [&] {
    const double x = draw.unit();
    return Vec2(x, draw.unit());
  };
  for (int i = 0; i < kPolygonsAScene; ++i) {
    const Vec2 a = point();
    add_ring(scene, {a, a + 0.25 * point(), a - 0.25 * point()});
  }
  return aimed(std::move(scene), [&](const AimedScene&) {
    const Vec2 origin = 2 * point() - Vec2(0.5, 0.5);
    return Ray{origin, point() - Vec2(0.5, 0.5)};
  });
}

// Points of a parabola closed by its chord are convex whatever their number.
AimedScene many_gon(Draw& draw) {
  AimedScene scene;
  for (int i = 0; i < kPolygonsAScene / 4; ++i) {
    const Vec2 corner(2.0 * i, draw.below(3));
    std::vector<Vec2> ring;
    for (int k = 0, n = 3 + static_cast<int>(draw.below(30)); k < n; ++k)
      ring.push_back(corner + Vec2(k / 32.0, k * k / 1024.0));
    add_ring(scene, ring);
  }
  return aimed(std::move(scene), [&](const AimedScene& made) {
    const Vec2 origin{9 * draw.unit() - 1, 4 * draw.unit() - 1};
    const Vec2 to = any_wall(made, draw).a;
    return Ray{origin, draw.unit() < 0.5 ? to - origin : nudge(to - origin, draw)};
  });
}

template <BezierScene (*make)(Draw&)>
AimedScene aimed_at(Draw& draw) {
  BezierScene made = make(draw);
  return {{}, std::move(made.rays), {}, std::move(made.curves)};
}

constexpr Family kFamilies[] = {
    {"grid", "everything on whole numbers: ends, ties and overlaps abound", &grid},
    {"vertex", "rays at ends of walls", &vertex},
    {"edge", "rays along walls", &edge},
    {"one-ulp", "rays an ulp off the ends of walls", &one_ulp},
    {"decimal", "tenths, which doubles do not hold", &decimal},
    {"near-parallel", "rays tilted against walls by 1 to 2^-59", &near_parallel},
    {"denormal", "in units of the smallest double", &denormal},
    {"huge", "in units of 2^1017", &huge},
    {"scaled", "in units of 2^-900 to 2^899", &scaled},
    {"offset", "moved by 2^52, where doubles are whole numbers", &offset},
    {"sliver", "flattened by up to 2^-1059", &sliver},
    {"mixed-magnitude", "every corner of a size of its own, 2^-100 to 2^99", &mixed_magnitude},
    {"degenerate", "points, repeated walls, walls on one line", &degenerate},
    {"zero-length", "rays without direction: what does the origin lie on", &zero_length},
    {"random", "uniform doubles", &random_scene},
    {"n-gon", "polygons of up to 32 corners", &many_gon},
    {"circles", "circles about whole numbers, tangents and chords through whole points", &circles},
    {"tangents", "rays within an ulp of tangents of circles", &tangents},
    {"from-circles", "rays from circles, or an ulp off them: along, inward, outward",
     &from_circles},
    {"arc-ends", "rays at ends of arcs on their circle, next to it and far off", &arc_ends},
    {"ellipses", "ellipses and parts of them, flattened by up to 2^-19", &ellipses},
    {"round-scaled", "circles and arcs in units of 2^-900 to 2^899", &round_scaled},
    {"round-offset", "circles and arcs moved by 2^30 to 2^49", &round_offset},
    {"round-magnitudes", "circles of radius and distance 2^-50 to 2^49", &round_magnitudes},
    {"beziers", "loops, cusps and inflections that doubles hold, and tangents there",
     &aimed_at<beziers>},
    {"bezier-scaled", "Bezier curves in units of 2^-900 to 2^899", &aimed_at<bezier_scaled>},
    {"bezier-offset", "Bezier curves moved by 2^10 to 2^29", &aimed_at<bezier_offset>},
    {"bezier-sliver", "Bezier curves flattened by up to 2^-299", &aimed_at<bezier_sliver>},
    {"bezier-random", "Bezier curves of random doubles", &aimed_at<bezier_random>},
};

}  // namespace

double nudge(double x, Draw& draw) {
  const double way = draw.below(3);
  return way == 0 ? x : std::nextafter(x, way == 1 ? -kInfinity : kInfinity);
}
Vec2 nudge(const Vec2& v, Draw& draw) {
  const double x = nudge(v.x(), draw);
  return {x, nudge(v.y(), draw)};
}

Surfaces AimedScene::surfaces() const {
  Surfaces all;
  const auto add_curves = [&] {
    for (const Arc& arc : curves) all.add(arc);
  };
  if (curves_first) add_curves();
  for (const Segment& wall : walls) all.add(wall);
  if (!curves_first) add_curves();
  for (const std::vector<Vec2>& p : beziers) all.add(Bezier(p));
  return all;
}

std::span<const Family> families() { return kFamilies; }

AimedScene make_scene(const Family& family, std::uint64_t seed, std::uint64_t item) {
  Draw draw(seed, static_cast<std::uint64_t>(&family - kFamilies), item);
  return family.make(draw);
}

}  // namespace flatray::oracle
