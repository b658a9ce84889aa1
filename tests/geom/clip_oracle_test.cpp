#include <fmt/core.h>
#include <gtest/gtest.h>

#include "full_counts.h"
#include "geom/clip_cases.h"
#include "oracle/exact.h"

namespace flatray {
namespace {

const int kClipsAFamily = static_cast<int>(times(1300));

using ClipFamily = Case (*)(Draw&);
struct NamedClips {
  const char* name;
  ClipFamily make;
};

const NamedClips kClipFamilies[] = {
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
  check_end(hit.t_enter, hit.enter_overflows, truth.first, tally);
  check_end(hit.t_exit, hit.exit_overflows, truth.last, tally);
}

TEST(ClipConvex, AgreesWithTheOracleOnAdversarialFamilies) {
  const Range ranges[] = {kRay, kSegment, kLine, {-0.5, 0.75}};
  Tally tally;
  int family = 0;
  for (const NamedClips& f : kClipFamilies) {
    for (int item = 0; item < kClipsAFamily; ++item) {
      Draw draw = draw_of(family, item);
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
  for (const int count : tally.kinds) EXPECT_GT(count, static_cast<int>(times(500)));
  EXPECT_LT(tally.not_nearest * 100, tally.ends);
}

}  // namespace
}  // namespace flatray
