#include <fmt/core.h>
#include <gtest/gtest.h>

#include "base/philox.h"
#include "geom/polygon.h"
#include "oracle/exact.h"

namespace flatray {
namespace {

constexpr std::uint64_t kSeed = 20181123;
constexpr int kCasesAFamily = 1300;

// The draws of one case, one after the other.
class Draw {
 public:
  Draw(int family, int item)
      : family_(static_cast<std::uint64_t>(family)), item_(static_cast<std::uint64_t>(item)) {}
  double unit() { return unit_double(random_bits(kSeed, Stream::test, family_, item_, draw_++)); }
  double below(int n) { return std::floor(unit() * n); }
  double sign() { return unit() < 0.5 ? -1 : 1; }

 private:
  std::uint64_t family_, item_;
  std::uint32_t draw_ = 0;
};

struct Case {
  std::vector<Vec2> polygon;
  Ray ray;
};

// A convex polygon on the integer grid [0, 8)^2, of either orientation, any first vertex; sometimes
// with repeated or collinear vertices, sometimes without area.
std::vector<Vec2> grid_polygon(Draw& draw) {
  for (;;) {
    std::vector<Vec2> ring;
    const int n = 3 + static_cast<int>(draw.below(4));
    for (int i = 0; i < n; ++i) ring.push_back({draw.below(8), draw.below(8)});
    if (!non_convex_vertex(ring)) return ring;
  }
}

Case grid_case(Draw& draw) {
  return {grid_polygon(draw),
          {{draw.below(12) - 2, draw.below(12) - 2}, {draw.below(9) - 4, draw.below(9) - 4}}};
}

Vec2 vertex_of(const Case& c, Draw& draw) {
  return c.polygon[static_cast<std::size_t>(draw.below(static_cast<int>(c.polygon.size())))];
}

Case map(Case c, const auto& f, double direction_scale = 1) {
  for (Vec2& v : c.polygon) v = f(v);
  const Vec2 tip = c.ray.origin + c.ray.direction;
  const Vec2 from = f(c.ray.origin);
  c.ray = {from, direction_scale * (f(tip) - from)};
  return c;
}

double nudge(double x, Draw& draw) {
  const double way = draw.below(3);
  return way == 0 ? x : std::nextafter(x, way == 1 ? -kInfinity : kInfinity);
}
Vec2 nudge(const Vec2& v, Draw& draw) { return {nudge(v.x(), draw), nudge(v.y(), draw)}; }

Case random_case(Draw& draw) {
  std::vector<Vec2> triangle;
  for (int i = 0; i < 3; ++i) triangle.push_back({draw.unit(), draw.unit()});
  return {triangle,
          {{2 * draw.unit() - 0.5, 2 * draw.unit() - 0.5}, {draw.unit() - 0.5, draw.unit() - 0.5}}};
}

using Family = Case (*)(Draw&);
struct NamedFamily {
  const char* name;
  Family make;
};

const NamedFamily kFamilies[] = {
    {"grid", &grid_case},
    {"vertex",
     [](Draw& draw) {
       Case c = grid_case(draw);
       c.ray.direction = vertex_of(c, draw) - c.ray.origin;
       return c;
     }},
    {"edge",
     [](Draw& draw) {
       Case c = grid_case(draw);
       const auto i = static_cast<std::size_t>(draw.below(static_cast<int>(c.polygon.size())));
       const Vec2 a = c.polygon[i], b = c.polygon[(i + 1) % c.polygon.size()];
       c.ray = {a + draw.below(4) * (a - b), draw.sign() * (b - a)};
       return c;
     }},
    {"one ulp",
     [](Draw& draw) {
       Case c = grid_case(draw);
       c.ray = {nudge(c.ray.origin, draw), nudge(vertex_of(c, draw) - c.ray.origin, draw)};
       return c;
     }},
    {"decimal",
     [](Draw& draw) { return map(grid_case(draw), [](const Vec2& v) { return Vec2(v / 10); }); }},
    {"near-parallel",
     [](Draw& draw) {
       Case c = grid_case(draw);
       const Vec2 a = c.polygon[0], e = c.polygon[1] - a;
       c.ray = {a - e, e + std::ldexp(draw.sign(), -static_cast<int>(draw.below(60))) *
                               Vec2(-e.y(), e.x())};
       return c;
     }},
    {"denormal",
     [](Draw& draw) {
       return map(grid_case(draw), [](const Vec2& v) { return Vec2(v * 5e-324); });
     }},
    {"huge",
     [](Draw& draw) {
       return map(grid_case(draw), [](const Vec2& v) { return Vec2(v * 0x1p1019); });
     }},
    {"scaled",
     [](Draw& draw) {
       const double scale = std::ldexp(1.0, static_cast<int>(draw.below(1800)) - 900);
       return map(grid_case(draw), [&](const Vec2& v) { return Vec2(v * scale); });
     }},
    {"offset to 2^52",
     [](Draw& draw) {
       const Vec2 offset(0x1p52 * draw.sign(), 0x1p52 * draw.sign());
       return map(grid_case(draw), [&](const Vec2& v) { return Vec2(v + offset); });
     }},
    {"sliver",
     [](Draw& draw) {
       const double thin = std::ldexp(1.0, -static_cast<int>(draw.below(1070)));
       return map(grid_case(draw), [&](const Vec2& v) { return Vec2(v.x(), v.y() * thin); });
     }},
    {"mixed magnitude",
     [](Draw& draw) {
       Case c = random_case(draw);
       for (Vec2& v : c.polygon) v *= std::ldexp(1.0, static_cast<int>(draw.below(200)) - 100);
       c.ray.direction *= std::ldexp(1.0, static_cast<int>(draw.below(200)) - 100);
       return c;
     }},
    {"degenerate",
     [](Draw& draw) {
       Case c = grid_case(draw);
       const Vec2 a = c.polygon[0], step(draw.below(3) - 1, draw.below(3) - 1);
       c.polygon.clear();
       for (int i = 0, n = 1 + static_cast<int>(draw.below(4)); i < n; ++i)
         c.polygon.push_back(a + draw.below(4) * step);
       if (draw.unit() < 0.5) c.ray.direction = c.polygon.back() - c.ray.origin;
       return c;
     }},
    {"zero length",
     [](Draw& draw) {
       Case c = grid_case(draw);
       c.ray.direction = {0, 0};
       return c;
     }},
    {"random", &random_case},
    {"many-gon",
     [](Draw& draw) {
       // Points of a parabola closed by its chord are convex whatever their number.
       Case c = random_case(draw);
       c.polygon.clear();
       const int n = 3 + static_cast<int>(draw.below(30));
       for (int i = 0; i < n; ++i) c.polygon.push_back({i / 32.0, i * i / 1024.0});
       return c;
     }},
};

struct Tally {
  int ends = 0, not_nearest = 0, kinds[4] = {0, 0, 0, 0};
};

void check_end(double t, bool overflows, const std::optional<Rational>& exact, Tally& tally) {
  if (!exact) return;
  const double nearest = exact->nearest();
  if (std::isinf(nearest)) {
    EXPECT_TRUE(overflows);
    EXPECT_EQ(t, std::copysign(std::numeric_limits<double>::max(), nearest));
    return;
  }
  EXPECT_FALSE(overflows);
  EXPECT_GE(t, std::nextafter(nearest, -kInfinity));
  EXPECT_LE(t, std::nextafter(nearest, kInfinity));
  ++tally.ends;
  tally.not_nearest += t != nearest ? 1 : 0;
}

void check_case(const Case& c, Range within, Tally& tally) {
  const HitInterval hit = clip_convex(c.ray, c.polygon, within);
  const oracle::Clip truth = oracle::clip_polygon(c.ray, c.polygon, within);
  EXPECT_STREQ(name(hit.kind), name(truth.kind));
  EXPECT_STREQ(name(hit.start), name(truth.start));
  EXPECT_EQ(hit.edge_enter, truth.edge_enter);
  EXPECT_EQ(hit.edge_exit, truth.edge_exit);
  EXPECT_EQ(hit.t_enter > hit.t_exit, hit.kind == HitClass::miss);
  ++tally.kinds[static_cast<int>(truth.kind)];
  if (truth.kind == HitClass::miss) return;
  check_end(hit.t_enter, hit.enter_overflows, truth.t_enter, tally);
  check_end(hit.t_exit, hit.exit_overflows, truth.t_exit, tally);
}

TEST(ClipConvex, AgreesWithTheOracleOnAdversarialFamilies) {
  const Range ranges[] = {kRay, kSegment, kLine, {-0.5, 0.75}};
  Tally tally;
  int family = 0;
  for (const NamedFamily& f : kFamilies) {
    for (int item = 0; item < kCasesAFamily; ++item) {
      Draw draw(family, item);
      const Case c = f.make(draw);
      if (non_convex_vertex(c.polygon)) continue;  // a family that rounds may bend an edge
      check_case(c, ranges[item % 4], tally);
      ASSERT_FALSE(testing::Test::HasFailure())
          << f.name << ", case " << item << " of seed " << kSeed;
    }
    ++family;
  }
  fmt::print(
      "seed {}: {} miss, {} touch, {} along, {} through; {} of {} t not the nearest double\n",
      kSeed, tally.kinds[0], tally.kinds[1], tally.kinds[2], tally.kinds[3], tally.not_nearest,
      tally.ends);
  for (const int count : tally.kinds) EXPECT_GT(count, 500);
  EXPECT_LT(tally.not_nearest * 100, tally.ends);
}

}  // namespace
}  // namespace flatray
