#include <gtest/gtest.h>

#include <optional>

#include "geom/exact.h"
#include "trace/many_rays.h"
#include "trace/random_rays.h"
#include "trace/tracer.h"

namespace flatray {
namespace {

NearestHit nearest(const Surfaces& walls, const Ray& ray, const DepartedSurface& departed = {},
                   bool tangents = true) {
  RayBatch rays;
  rays.tangents = tangents;
  rays.add(ray, departed);
  rays = many_of(rays);
  std::vector<NearestHit> hits(rays.size());
  const auto made = accelerate(walls);
  made->nearest(rays, hits);
  const NearestHit hit = made->nearest_of_one(ray, departed, tangents);
  for (const NearestHit& by_lanes : hits) EXPECT_EQ(by_lanes, hit);
  return hit;
}

struct Answer {
  std::uint32_t surface = kNoSurface;
  Rational t;
};

// What a ray meets first, from t = ((a - o) x e) / (d x e) and u = ((a - o) x d) / (d x e) in
// rationals.
class Truth {
 public:
  explicit Truth(const Ray& ray)
      : ox_(ray.origin.x()), oy_(ray.origin.y()), dx_(ray.direction.x()), dy_(ray.direction.y()) {}

  void meet(std::uint32_t surface, const Segment& s) {
    const Rational ax = Rational(s.a.x()) - ox_, ay = Rational(s.a.y()) - oy_;
    const Rational ex = Rational(s.b.x()) - s.a.x(), ey = Rational(s.b.y()) - s.a.y();
    const Rational det = dx_ * ey - dy_ * ex;
    if (det.sign() != Sign::zero) {
      const Rational u = (ax * dy_ - ay * dx_) / det;
      if (u >= Rational(0) && u <= Rational(1)) offer(surface, (ax * ey - ay * ex) / det);
    } else if ((ax * dy_ - ay * dx_).sign() == Sign::zero) {
      const Rational size = dx_ * dx_ + dy_ * dy_;
      const Rational t = (ax * dx_ + ay * dy_) / size;
      const Rational other = t + (ex * dx_ + ey * dy_) / size;
      const bool around = t.sign() != other.sign() || t.sign() == Sign::zero;
      offer(surface, around ? Rational(0) : t < other ? t : other);
    }
  }
  // Needs a ray along x whose line cuts the circle in rational points: half the chord.
  void meet(std::uint32_t surface, const Circle& circle, double half_chord) {
    for (const double side : {-1.0, 1.0})
      offer(surface, (Rational(circle.centre.x()) + side * half_chord - ox_) / dx_);
  }
  Answer answer;

 private:
  void offer(std::uint32_t surface, const Rational& t) {
    if (t.sign() == Sign::negative) return;
    if (answer.surface != kNoSurface && t >= answer.t) return;
    answer = {surface, t};
  }
  Rational ox_, oy_, dx_, dy_;
};

void expect_answer(const Answer& truth, const NearestHit& hit) {
  ASSERT_EQ(hit.surface, truth.surface);
  if (hit) {
    EXPECT_EQ(hit.t, truth.t.nearest());
  }
}

// Crossings, duplicates, T-joints, collinear runs, points, rays that start on walls: all on a small
// grid.
Surfaces grid_scene(Draws& draw, int count) {
  Surfaces walls;
  for (int i = 0; i < count; ++i)
    walls.add(i > 0 && draw.whole(0, 9) == 0
                  ? walls.segments[0]
                  : Segment{draw.grid_point(-4, 4), draw.grid_point(-4, 4)});
  return walls;
}

TEST(Nearest, AgreesWithRationalsOnIntegerScenes) {
  Draws draw(1);
  int hits = 0, at_ends = 0;
  for (int scene = 0; scene < 40; ++scene) {
    const Surfaces walls = grid_scene(draw, 1 + scene % 12);
    for (int k = 0; k < 40; ++k) {
      const Ray ray{draw.grid_point(-5, 5), draw.grid_point(-3, 3)};
      if (ray.direction == Vec2(0, 0)) continue;
      const std::uint32_t left =
          k % 3 == 0 ? static_cast<std::uint32_t>(draw.whole(0, static_cast<int>(walls.size()) - 1))
                     : kNoSurface;
      Truth truth(ray);
      for (std::uint32_t i = 0; i < walls.size(); ++i)
        if (i != left) truth.meet(i, walls.segments[i]);
      const NearestHit hit = nearest(walls, ray, {left, Root::none});
      expect_answer(truth.answer, hit);
      hits += hit ? 1 : 0;
      at_ends += hit.at_end ? 1 : 0;
    }
  }
  EXPECT_GT(hits, 500);
  EXPECT_GT(at_ends, 50);
}

// The same off the grid of small doubles: factor 0.1 rounds every coordinate, offset 1e6 eats its
// bits.
TEST(Nearest, AgreesWithRationalsOnRoundedScenes) {
  Draws draw(2);
  for (int scene = 0; scene < 40; ++scene) {
    const Surfaces grid = grid_scene(draw, 8);
    const Vec2 offset = scene % 2 == 0 ? Vec2(0, 0) : Vec2(1e6, -1e6);
    Surfaces walls;
    for (const Segment& s : grid.segments)
      walls.add(Segment{0.1 * s.a + offset, 0.1 * s.b + offset});
    for (int k = 0; k < 30; ++k) {
      const Ray ray{0.1 * draw.grid_point(-5, 5) + offset, draw.grid_point(-3, 3) / 3};
      if (ray.direction == Vec2(0, 0)) continue;
      Truth truth(ray);
      for (std::uint32_t i = 0; i < walls.size(); ++i) truth.meet(i, walls.segments[i]);
      expect_answer(truth.answer, nearest(walls, ray));
    }
  }
}

// Circles of radius 5 on whole centres: rays along x at height 0, 3, 4, 5 cut half chords of 5, 4,
// 3, 0.
TEST(Nearest, AgreesWithRationalsOnCircles) {
  Draws draw(3);
  const std::array<double, 6> half_chord = {5, -1, -1, 4, 3, 0};
  for (int scene = 0; scene < 200; ++scene) {
    Surfaces walls;
    const Ray ray{draw.grid_point(-9, 9), {static_cast<double>(draw.whole(0, 1) * 8 - 4), 0}};
    Truth truth(ray);
    for (std::uint32_t i = 0; i < 4; ++i) {
      if (i == 2) {
        const double x = draw.whole(-9, 9);
        walls.add(Segment{{x, -20}, {x, 20}});
        truth.meet(i, walls.segments.back());
        continue;
      }
      const int rise = draw.whole(0, 5);
      if (half_chord[static_cast<std::size_t>(rise)] < 0) {
        walls.add(Circle{{0, 100}, 5});
        continue;
      }
      const Circle circle{{static_cast<double>(draw.whole(-9, 9)), ray.origin.y() + rise}, 5};
      walls.add(circle);
      truth.meet(i, circle, half_chord[static_cast<std::size_t>(rise)]);
    }
    const NearestHit hit = nearest(walls, ray);
    expect_answer(truth.answer, hit);
    if (hit && walls.segment_slot(hit.surface) == kNoSurface) {
      const bool tangent = walls.arc(hit.surface).curve.centre.y() - ray.origin.y() == 5;
      EXPECT_EQ(hit.root == Root::both, tangent);
      EXPECT_EQ(hit.kind, tangent ? HitClass::touch : HitClass::through);
    }
  }
}

TEST(Nearest, ACircleIsLeftInTheRootStoodOn) {
  Surfaces walls;
  walls.add(Circle{{0, 0}, 1});
  const NearestHit from_inside = nearest(walls, {{-1, 0}, {1, 0}}, {0, Root::first});
  EXPECT_EQ(from_inside.root, Root::second);
  EXPECT_EQ(from_inside.t, 2);
  EXPECT_FALSE(nearest(walls, {{1, 0}, {1, 0}}, {0, Root::second}));
  EXPECT_FALSE(nearest(walls, {{-1, 0}, {1, 0}}, {0, Root::both}));
  EXPECT_EQ(nearest(walls, {{-1, 0}, {1, 0}}).t, 0);
}

TEST(Nearest, TangentsArePassedByOnRequest) {
  Surfaces walls;
  walls.add(Circle{{0, 0}, 5});
  walls.add(Segment{{10, -10}, {10, 10}});
  const Ray ray{{-5, 10}, {4, -3}};  // touches at (3, 4)
  EXPECT_EQ(nearest(walls, ray).surface, 0U);
  EXPECT_EQ(nearest(walls, ray).t, 2);
  EXPECT_EQ(nearest(walls, ray, {}, false).surface, 1U);
}

TEST(Nearest, AZeroDirectionAsksWhatTheOriginLiesOn) {
  Surfaces walls;
  walls.add(Segment{{0, 1}, {1, 1}});
  walls.add(Segment{{0, 0}, {1, 0}});
  walls.add(Circle{{0.5, 1}, 1});
  const NearestHit hit = nearest(walls, {{0.5, 0}, {0, 0}});
  EXPECT_EQ(hit.surface, 1U);
  EXPECT_EQ(hit.t, 0);
  EXPECT_FALSE(hit.at_end);
  EXPECT_TRUE(nearest(walls, {{1, 0}, {0, 0}}).at_end);
  EXPECT_FALSE(nearest(walls, {{0.5, 0.5}, {0, 0}}));
}

TEST(Nearest, ARayAlongAWallArrivesAtItsEnd) {
  Surfaces walls;
  walls.add(Segment{{3, 0}, {1, 0}});
  const NearestHit ahead = nearest(walls, {{0, 0}, {2, 0}});
  EXPECT_EQ(ahead.kind, HitClass::along);
  EXPECT_TRUE(ahead.at_end);
  EXPECT_EQ(ahead.t, 0.5);
  const NearestHit inside = nearest(walls, {{2, 0}, {2, 0}});
  EXPECT_EQ(inside.kind, HitClass::along);
  EXPECT_FALSE(inside.at_end);
  EXPECT_EQ(inside.t, 0);
  EXPECT_EQ(nearest(walls, {{3, 0}, {2, 0}}).kind, HitClass::touch);
  EXPECT_FALSE(nearest(walls, {{4, 0}, {2, 0}}));
}

TEST(Nearest, NothingLiesAheadInAnEmptyScene) {
  EXPECT_FALSE(nearest(Surfaces{}, {{0, 0}, {1, 0}}));
}

TEST(StiffCases, B11CoincidentEdges) {
  Surfaces walls;
  walls.add(Segment{{0, 1}, {1, 1}});
  for (int i = 0; i < 10'000; ++i) walls.add(Segment{{0, 0}, {1, 0}});
  const NearestHit hit = nearest(walls, {{0.5, -1}, {0, 1}});
  EXPECT_EQ(hit.surface, 1U);
  EXPECT_EQ(hit.t, 1);
}

TEST(Tracers, AreFoundByName) {
  ASSERT_NE(find_tracer("brute"), nullptr);
  EXPECT_STREQ(find_tracer("brute")->name, "brute");
  EXPECT_EQ(find_tracer("brut"), nullptr);
}

TEST(Tracers, AreChosenByTheNumberOfWalls) {
  Surfaces walls;
  for (int i = 0; i < 24; ++i) walls.add(Segment{{0, 0}, {1, 0}});
  EXPECT_STREQ(choose_tracer(walls).tracer->name, "brute");
  walls.add(Segment{{0, 0}, {1, 0}});
  EXPECT_STREQ(choose_tracer(walls).tracer->name, "grid");
  EXPECT_EQ(choose_tracer(walls).reason, "25 segments: more than 24");
}

}  // namespace
}  // namespace flatray
