// What <flatray/trace.h> gives is what the modules give, bit for bit, and mistakes of callers are told.
#include <gtest/gtest.h>

#include <limits>

#include "flatray/trace.h"
#include "trace/hit_intervals.h"
#include "trace/random_rays.h"
#include "trace/tracer.h"

namespace flatray {
namespace {

using Numbers = std::vector<double>;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

void expect_fault(api::Status status, api::Fault fault, std::size_t entry = 0) {
  EXPECT_EQ(status.fault, fault) << api::words(status.fault);
  EXPECT_EQ(status.entry, entry);
  EXPECT_FALSE(status);
}

// Columns of points of whole numbers, so that rays meet ends, tangents and several walls at once.
struct Points {
  Numbers x, y;
  void add(const Vec2& p) { x.push_back(p.x()), y.push_back(p.y()); }
};

// The same walls twice: as the library has them, and by the public calls.
struct Twice {
  Surfaces surfaces;
  api::Walls walls;
};

Twice any_walls(Draws& draw) {
  Twice both;
  Points a, b, ring, centre, u, v, from, to;
  Numbers radius;
  for (int i = 0; i < 6; ++i) {
    a.add(draw.grid_point(-9, 9)), b.add(draw.grid_point(-9, 9));
    both.surfaces.add(Segment{{a.x.back(), a.y.back()}, {b.x.back(), b.y.back()}});
  }
  for (int i = 0; i < 5; ++i) ring.add(draw.grid_point(-9, 9));
  for (std::size_t i = 0; i < 5; ++i) {
    const std::size_t next = (i + 1) % 5;
    both.surfaces.add(Segment{{ring.x[i], ring.y[i]}, {ring.x[next], ring.y[next]}});
  }
  for (int i = 0; i < 3; ++i) {
    centre.add(draw.grid_point(-9, 9));
    radius.push_back(1 + draw.whole(0, 4));
    both.surfaces.add(Circle{{centre.x.back(), centre.y.back()}, radius.back()});
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const double p = 1 + draw.whole(0, 3), q = draw.whole(-3, 3);
    u.add({p, 1}), v.add({q * p - 1, q});  // of area p q - (q p - 1) = 1
    const Ellipse curve({centre.x[i], centre.y[i]}, {p, 1}, {q * p - 1, q});
    both.surfaces.add(Arc{curve, Arc::Extent::whole, {0, 0}, {0, 0}});
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 middle(centre.x[i], centre.y[i]), away(1 + draw.whole(0, 3), draw.whole(-3, 3));
    from.add(middle + away), to.add(middle - away);
    both.surfaces.add(
        Arc{Circle{middle, radius[i]}, Arc::Extent::between, middle + away, middle - away});
  }
  EXPECT_TRUE(both.walls.add_segments(a.x, a.y, b.x, b.y));
  EXPECT_TRUE(both.walls.add_ring(ring.x, ring.y));
  EXPECT_TRUE(both.walls.add_circles(centre.x, centre.y, radius));
  EXPECT_TRUE(both.walls.add_ellipses(centre.x, centre.y, u.x, u.y, v.x, v.y));
  EXPECT_TRUE(both.walls.add_arcs(centre.x, centre.y, radius, from.x, from.y, to.x, to.y));
  for (const int degree : {2, 3}) {
    Points control;
    for (int i = 0; i < 2; ++i) {
      std::vector<Vec2> points;
      do {
        points.clear();
        for (int k = 0; k <= degree; ++k) points.push_back(draw.grid_point(-9, 9));
      } while (is_on_one_line(Bezier(points)));
      for (const Vec2& p : points) control.add(p);
      both.surfaces.add(Bezier(points));
    }
    EXPECT_TRUE(both.walls.add_beziers(degree, control.x, control.y));
  }
  Points control;
  Numbers weight;
  for (const double w : {0.25, 1.0, 3.0}) {
    Bezier curve({0, 0}, {1, 0}, {1, 1}, w);
    curve = mapped(curve, [&](const Vec2& p) { return Vec2(p + draw.grid_point(-9, 9)); });
    if (is_on_one_line(curve)) continue;
    for (int k = 0; k < 3; ++k) control.add(curve.point(k));
    weight.push_back(w);
    both.surfaces.add(curve);
  }
  EXPECT_TRUE(both.walls.add_conics(control.x, control.y, weight));
  EXPECT_EQ(both.walls.size(), both.surfaces.size());
  return both;
}

// Rays as the library has them, and as arrays.
struct TwiceRays {
  RayBatch batch;
  std::vector<api::DepartedSurface> departed;
  api::Rays rays() const {
    return {batch.ox, batch.oy, batch.dx, batch.dy, departed, batch.tangents};
  }
};

TwiceRays any_rays(Draws& draw, std::size_t count, int walls) {
  TwiceRays both;
  both.batch.tangents = draw.whole(0, 1) == 0;
  for (std::size_t i = 0; i < count; ++i) {
    DepartedSurface from;
    if (walls > 0 && draw.whole(0, 3) == 0)
      from = {static_cast<std::uint32_t>(draw.whole(0, walls - 1)),
              static_cast<Root>(draw.whole(1, 3))};
    both.batch.add({draw.grid_point(-9, 9), draw.grid_point(-4, 4)}, from);
    both.departed.push_back({from.surface, static_cast<api::Root>(from.root)});
  }
  return both;
}

bool same(const api::Hit& a, const NearestHit& b) {
  return a.wall == b.surface && a.kind == static_cast<api::HitClass>(b.kind) &&
         a.root == static_cast<api::Root>(b.root) && a.at_end == b.at_end && a.t == b.t;
}

bool same(const api::Interval& a, const HitInterval& b) {
  return a.enter == b.t_enter && a.exit == b.t_exit && a.edge_enter == b.edge_enter &&
         a.edge_exit == b.edge_exit && a.kind == static_cast<api::HitClass>(b.kind) &&
         a.start == static_cast<api::StartPlace>(b.start) &&
         a.enter_overflows == b.enter_overflows && a.exit_overflows == b.exit_overflows;
}

TEST(PublicTrace, HitsAreThoseOfTheModule) {
  Draws draw(71);
  std::size_t met_in_all = 0;
  for (const std::size_t count : {1U, 15U, 300U, 4095U, 4097U, 9000U}) {
    const Twice both = any_walls(draw);
    const auto truth = accelerate(both.surfaces);
    const api::RayTracer tracer(both.walls);
    const TwiceRays asked = any_rays(draw, count, static_cast<int>(both.walls.size()));
    std::vector<NearestHit> wanted(count), wanted_all;
    std::vector<api::Hit> hits(count), all;
    truth->nearest(asked.batch, wanted);
    ASSERT_TRUE(tracer.nearest(asked.rays(), hits));
    for (std::size_t i = 0; i < count; ++i) ASSERT_TRUE(same(hits[i], wanted[i])) << i;

    Numbers up_to;
    for (std::size_t i = 0; i < count; ++i)
      up_to.push_back(i % 3 == 0 ? wanted[i].t : draw.spread(-3, 3));
    std::vector<std::uint8_t> met(count), wanted_met(count);
    truth->any(asked.batch, up_to, wanted_met);
    ASSERT_TRUE(tracer.any(asked.rays(), up_to, met));
    EXPECT_EQ(met, wanted_met);

    std::vector<std::size_t> ends, wanted_ends;
    for (std::size_t i = 0; i < count; ++i) {
      const std::vector<NearestHit> every =
          truth->all_of_one(asked.batch.ray(i), asked.batch.departed[i], asked.batch.tangents);
      wanted_all.insert(wanted_all.end(), every.begin(), every.end());
      wanted_ends.push_back(wanted_all.size());
    }
    ASSERT_TRUE(tracer.all(asked.rays(), all, ends));
    ASSERT_EQ(ends, wanted_ends);
    ASSERT_EQ(all.size(), wanted_all.size());
    for (std::size_t i = 0; i < all.size(); ++i) ASSERT_TRUE(same(all[i], wanted_all[i])) << i;
    met_in_all += all.size();
  }
  EXPECT_GT(met_in_all, 10000U);
}

TEST(PublicTrace, IntervalsAreThoseOfTheModule) {
  Draws draw(72);
  int through = 0;
  for (const std::size_t count : {1U, 300U, 4097U}) {
    for (const api::Range within : {api::kRay, api::kLine, api::kSegment, api::Range{0.25, 0.5}}) {
      const Vec2 at = draw.grid_point(-5, 5);
      Points polygon;
      std::vector<Vec2> vertices;
      for (const Vec2& p : {Vec2(0, 0), Vec2(4, 1), Vec2(5, 4), Vec2(5, 4), Vec2(1, 4)}) {
        polygon.add(at + p);
        vertices.push_back(at + p);
      }
      const TwiceRays asked = any_rays(draw, count, 0);
      std::vector<api::Interval> parts(count), discs(count);
      ASSERT_TRUE(api::clip_convex(asked.rays(), polygon.x, polygon.y, within, parts));
      ASSERT_TRUE(api::clip_disc(asked.rays(), at.x(), at.y(), 3, within, discs));
      const Range range{within.low, within.high};
      for (std::size_t i = 0; i < count; ++i) {
        ASSERT_TRUE(same(parts[i], clip_convex(asked.batch.ray(i), vertices, range))) << i;
        ASSERT_TRUE(same(discs[i], clip_circle(asked.batch.ray(i), {at, 3}, range))) << i;
        through += parts[i].kind == api::HitClass::through ? 1 : 0;
      }
    }
  }
  EXPECT_GT(through, 1000);
}

TEST(PublicTrace, MistakesInWallsAreToldAndAddNothing) {
  using api::Fault;
  api::Walls walls;
  const Numbers zero = {0, 0, 0}, one = {1, 1, 1}, two = {2, 2, 2}, none;
  ASSERT_TRUE(walls.add_ring(zero, one));
  expect_fault(walls.add_segments(zero, zero, one, Numbers{1, 2}), Fault::sizes);
  expect_fault(walls.add_segments(zero, zero, one, Numbers{1, kNaN, 2}), Fault::not_finite, 1);
  expect_fault(walls.add_ring(zero, Numbers{1, 2, kInfinity}), Fault::not_finite, 2);
  expect_fault(walls.add_ring(zero, none), Fault::sizes);
  expect_fault(walls.add_ring(none, none), Fault::empty);
  expect_fault(walls.add_circles(zero, zero, Numbers{1, 0, -1e-300}), Fault::radius, 2);
  expect_fault(walls.add_circles(zero, zero, Numbers{-1, 0, kNaN}), Fault::not_finite, 2);
  expect_fault(walls.add_circles(zero, zero, none), Fault::sizes);
  expect_fault(walls.add_ellipses(zero, zero, one, two, two, Numbers{5, 4, 5}), Fault::degenerate,
               1);
  const auto arcs = [&](const Numbers& radius, const Numbers& x, const Numbers& y,
                        const Numbers& to_x, const Numbers& to_y) {
    return walls.add_arcs(zero, zero, radius, x, y, to_x, to_y);
  };
  expect_fault(arcs(one, one, two, two, Numbers{5, 4, 5}), Fault::degenerate, 1);
  expect_fault(arcs(one, one, zero, two, zero), Fault::degenerate, 0);
  expect_fault(arcs(one, Numbers{1, 0, 0}, Numbers{1, 1, 0}, two, one), Fault::degenerate, 2);
  expect_fault(arcs(Numbers{1, 0, 1}, one, two, two, one), Fault::degenerate, 1);
  expect_fault(arcs(Numbers{1, -1, 1}, one, two, two, one), Fault::radius, 1);
  const Numbers six_x = {0, 1, 2, 0, 1, 2}, six_y = {0, 1, 0, 0, 1, 2};
  expect_fault(walls.add_beziers(2, six_x, six_y), Fault::degenerate, 1);
  expect_fault(walls.add_conics(six_x, six_y, Numbers{2, 2}), Fault::degenerate, 1);
  expect_fault(walls.add_conics(six_x, six_y, Numbers{0, 2}), Fault::degenerate, 0);
  expect_fault(walls.add_conics(six_x, six_y, Numbers{0x1p41, 2}), Fault::degenerate, 0);
  expect_fault(walls.add_conics(six_x, six_y, Numbers{2}), Fault::sizes);
  expect_fault(walls.add_beziers(3, six_x, six_y), Fault::sizes);
  expect_fault(walls.add_beziers(1, six_x, six_y), Fault::sizes);
  expect_fault(walls.add_beziers(2, six_x, zero), Fault::sizes);
  expect_fault(walls.add_beziers(2, zero, Numbers{0, kNaN, 1}), Fault::not_finite, 1);
  EXPECT_EQ(walls.size(), 3U);
  EXPECT_TRUE(arcs(one, one, two, Numbers{-1, -1, -1}, Numbers{-2, -2, -2}));  // half a turn
  EXPECT_EQ(walls.size(), 6U);
}

TEST(PublicTrace, MistakesInRaysAreToldAndWriteNothing) {
  using api::Fault;
  api::Walls walls;
  const Numbers x = {0, 4, 4, 0}, y = {0, 0, 4, 4}, one = {1, 1}, bad = {1, kNaN}, three(3, 1);
  ASSERT_TRUE(walls.add_ring(x, y));
  const api::RayTracer tracer(walls);
  const api::Hit kept{3, 3};
  std::vector<api::Hit> hits(2, kept), few(1, kept);
  const std::vector<api::DepartedSurface> departed = {{0}, {4}}, short_left = {{0}};
  expect_fault(tracer.nearest({one, one, one, bad}, hits), Fault::not_finite, 1);
  expect_fault(tracer.nearest({one, one, one, three}, hits), Fault::sizes);
  expect_fault(tracer.nearest({one, one, one, one}, few), Fault::sizes);
  expect_fault(tracer.nearest({one, one, one, one, departed}, hits), Fault::no_such, 1);
  expect_fault(tracer.nearest({one, one, one, one, short_left}, hits), Fault::sizes);
  EXPECT_EQ(hits, std::vector<api::Hit>(2, kept));

  std::vector<std::uint8_t> met(2, 7);
  expect_fault(tracer.any({one, one, one, one}, bad, met), Fault::not_finite, 1);
  expect_fault(tracer.any({one, one, one, one}, three, met), Fault::sizes);
  EXPECT_EQ(met, std::vector<std::uint8_t>(2, 7));
  EXPECT_TRUE(tracer.any({one, one, one, one}, Numbers{kInfinity, -kInfinity}, met));
  EXPECT_EQ(met, (std::vector<std::uint8_t>{1, 0}));

  std::vector<std::size_t> ends(5, 9);
  expect_fault(tracer.all({one, one, bad, one}, hits, ends), Fault::not_finite, 1);
  EXPECT_EQ(ends.size(), 5U);

  const api::Interval before{2, 3};
  std::vector<api::Interval> parts(2, before), few_parts(3, before);
  const api::Rays rays{one, one, one, one};
  expect_fault(api::clip_convex(rays, x, y, api::kRay, few_parts), Fault::sizes);
  expect_fault(api::clip_convex(rays, x, y, {kNaN, 1}, parts), Fault::not_finite);
  expect_fault(api::clip_convex(rays, Numbers{}, Numbers{}, api::kRay, parts), Fault::empty);
  expect_fault(api::clip_convex(rays, Numbers{0, 4, 1, 0}, Numbers{0, 0, 1, 4}, api::kRay, parts),
               Fault::not_convex, 2);
  expect_fault(api::clip_disc(rays, 0, 0, -1, api::kRay, parts), Fault::radius);
  expect_fault(api::clip_disc(rays, 0, kNaN, 1, api::kRay, parts), Fault::not_finite);
  EXPECT_EQ(parts, std::vector<api::Interval>(2, before));
}

TEST(PublicTrace, WhatWasMovedFromIsEmptyAndMayBeUsedAgain) {
  const Numbers x = {0, 4, 4, 0}, y = {0, 0, 4, 4}, one = {1}, zero = {0};
  api::Walls walls;
  ASSERT_TRUE(walls.add_ring(x, y));
  const api::Walls copy = walls;
  api::RayTracer tracer(std::move(walls));
  EXPECT_EQ(walls.size(), 0U);  // NOLINT(bugprone-use-after-move)
  ASSERT_TRUE(walls.add_ring(x, y));
  EXPECT_EQ(walls.size(), 4U);
  EXPECT_EQ(copy.size(), 4U);

  const api::RayTracer taken = std::move(tracer);
  std::vector<api::Hit> hits(1);
  std::vector<std::size_t> ends;
  std::vector<std::uint8_t> met(1, 7);
  ASSERT_TRUE(taken.nearest({one, one, one, zero}, hits));
  EXPECT_EQ(hits[0].wall, 1U);
  ASSERT_TRUE(tracer.nearest({one, one, one, zero}, hits));  // NOLINT(bugprone-use-after-move)
  EXPECT_EQ(hits[0], api::Hit{});
  ASSERT_TRUE(tracer.any({one, one, one, zero}, one, met));
  EXPECT_EQ(met[0], 0);
  ASSERT_TRUE(tracer.all({one, one, one, zero}, hits, ends));
  EXPECT_EQ(ends, std::vector<std::size_t>{0});
  EXPECT_TRUE(api::RayTracer(api::Walls()).nearest({one, one, one, zero}, hits = {{}}));
}

TEST(PublicTrace, WhatWasAssignedFromIsEmptyAndWhatIsAssignedToItselfIsKept) {
  const Numbers x = {0, 4, 4, 0}, y = {0, 0, 4, 4}, one = {1}, zero = {0};
  api::Walls ring, segment;
  ASSERT_TRUE(ring.add_ring(x, y));
  ASSERT_TRUE(segment.add_segments(zero, zero, one, one));
  api::RayTracer to(segment), from(ring);
  to = std::move(from);
  EXPECT_EQ(to.walls(), 4U);
  EXPECT_EQ(from.walls(), 0U);  // NOLINT(bugprone-use-after-move)
  api::RayTracer& same = to;
  to = std::move(same);
  EXPECT_EQ(to.walls(), 4U);

  segment = std::move(ring);
  EXPECT_EQ(segment.size(), 4U);
  EXPECT_EQ(ring.size(), 0U);  // NOLINT(bugprone-use-after-move)
}

TEST(PublicTrace, EveryFaultHasItsOwnWords) {
  std::vector<std::string> all;
  for (int i = 0; i <= static_cast<int>(api::Fault::full); ++i)
    all.emplace_back(api::words(static_cast<api::Fault>(i)));
  std::sort(all.begin(), all.end());
  EXPECT_EQ(std::unique(all.begin(), all.end()), all.end());
  const std::string degenerate = api::words(api::Fault::degenerate);
  for (const char* what : {"ellipse", "arc", "curve", "weight"})
    EXPECT_NE(degenerate.find(what), std::string::npos) << what;
}

}  // namespace
}  // namespace flatray
