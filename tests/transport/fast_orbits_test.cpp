#include "transport/fast_orbits.h"

#include <gtest/gtest.h>

#include <cmath>

#include "transport/chambers.h"

namespace flatray {
namespace {

// A room, what is outside it, and starts in it.
struct Closed {
  const char* name;
  Surfaces walls;
  std::vector<Material> materials;

  Closed(const char* name_, Surfaces walls_, std::size_t periodic = 0)
      : name(name_), walls(std::move(walls_)), materials(walls.size(), Material::mirror) {
    std::fill_n(materials.begin(), periodic, Material::periodic);
  }
  std::vector<OrbitStart> starts(std::size_t count) const {
    std::vector<OrbitStart> all;
    for (std::size_t i = 0; i < count; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(count),
                   angle = 0.1 + 6 * share;
      all.push_back({{{0.05 + 0.1 * share, 0.1}, {3 * std::cos(angle), 3 * std::sin(angle)}}});
    }
    return all;
  }
};

Surfaces with(Surfaces walls, const Arc& arc) {
  walls.add(arc);
  return walls;
}

std::vector<Closed> rooms() {
  const auto whole = Arc::Extent::whole, half = Arc::Extent::half, between = Arc::Extent::between;
  const Surfaces box = ring({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const Arc disc{Circle{{0.5, 0.5}, 0.25}, whole, {0, 0}, {0, 0}};
  Surfaces stadium;
  stadium.add(Segment{{-1, -1}, {1, -1}});
  stadium.add(Arc{Circle{{1, 0}, 1}, half, {1, 0}, {0, 0}});
  stadium.add(Segment{{1, 1}, {-1, 1}});
  stadium.add(Arc{Circle{{-1, 0}, 1}, half, {-1, 0}, {0, 0}});
  Surfaces quarter;
  quarter.add(Segment{{0, 0}, {1, 0}});
  quarter.add(Arc{Circle{{0, 0}, 1}, between, {1, 0}, {0, 1}});
  quarter.add(Segment{{0, 1}, {0, 0}});
  return {
      {"box", box},
      {"Sinai", with(box, disc)},
      {"Lorentz", with(box, disc), 4},
      {"slanting", with(ring({{-1, -1}, {2, -0.5}, {1.5, 1.25}, {0.1, 1.5}, {0, 0.5}}),
                        Arc{Circle{{1, 0.5}, 0.2}, whole, {0, 0}, {0, 0}})},
      {"stadium", stadium},
      {"quarter", quarter},
      {"ellipse", with({}, Arc{Ellipse({0, 0}, {1.5, 0.5}, {-0.5, 1}), whole, {0, 0}, {0, 0}})}};
}

// Bounces by orbit, and how orbits end.
struct Kept : OrbitSink {
  explicit Kept(std::size_t orbits) : bounces(orbits), ends(orbits) {}
  void bounce(std::size_t number, const Bounce& bounce) override {
    bounces[number].push_back(bounce);
  }
  void end(std::size_t number, const OrbitStop& stop) override { ends[number] = stop.end; }
  std::vector<std::vector<Bounce>> bounces;
  std::vector<OrbitEnd> ends;
};

bool is_same(const Bounce& a, const Bounce& b) {
  return a.surface == b.surface && a.point == b.point && a.t == b.t &&
         a.path_length == b.path_length && a.normal == b.normal && a.in == b.in && a.out == b.out;
}

TEST(FastOrbits, HaveTheSameBitsInEveryTierAndInAnyCompany) {
  for (const Closed& room : rooms()) {
    const OrbitTracer exact(room.walls, room.materials);
    const std::vector<OrbitStart> starts = room.starts(300);
    Kept first(starts.size());
    FastOrbits(exact, true, Isa::portable).follow(starts, 40, first);
    for (const Isa isa : available_isas()) {
      const FastOrbits fast(exact, true, isa);
      ASSERT_EQ(fast.obstacle(), "");
      Kept all(starts.size()), alone(1);
      fast.follow(starts, 40, all);
      fast.follow(std::span(starts).subspan(290, 1), 40, alone);
      for (std::size_t i = 0; i < starts.size(); ++i)
        EXPECT_TRUE(std::equal(all.bounces[i].begin(), all.bounces[i].end(),
                               first.bounces[i].begin(), first.bounces[i].end(), &is_same))
            << room.name << " " << isa_name(isa) << " " << i;
      EXPECT_TRUE(std::equal(alone.bounces[0].begin(), alone.bounces[0].end(),
                             first.bounces[290].begin(), first.bounces[290].end(), &is_same));
    }
  }
}

// Each bounce beside what the exact tracer makes of the same flight.
class Checked : public OrbitSink {
 public:
  Checked(const Closed& room, const OrbitTracer& exact, std::size_t orbits)
      : room_(room), exact_(exact), last_(orbits) {}
  void bounce(std::size_t number, const Bounce& bounce) override {
    ++bounces;
    EXPECT_NEAR(bounce.out.squaredNorm(), 1, 4e-15);
    EXPECT_LT(distance_to_wall(bounce), 1e-15) << room_.name;
    if (bounces % 7 == 0 && last_[number]) check_flight(*last_[number], bounce);
    last_[number] = bounce;
  }
  void end(std::size_t, const OrbitStop& stop) override {
    if (stop.end != OrbitEnd::limit && stop.end != OrbitEnd::corner) ++lost;
  }
  std::size_t bounces = 0, lost = 0, other_walls = 0;
  double worst = 0;  // distance of points, times the cosine of the incidence

 private:
  double distance_to_wall(const Bounce& bounce) const {
    return room_.walls.visit(bounce.surface, [&](const auto& wall) {
      if constexpr (std::is_same_v<std::decay_t<decltype(wall)>, Segment>) {
        const Vec2 way = wall.b - wall.a, from = bounce.point - wall.a;
        return std::fabs(way.x() * from.y() - way.y() * from.x()) / way.norm();
      } else if constexpr (std::is_same_v<std::decay_t<decltype(wall)>, Arc>) {
        const Vec2 from = bounce.point - wall.curve.centre, &u = wall.curve.u, &v = wall.curve.v;
        const double area = u.x() * v.y() - u.y() * v.x();
        const double a = (from.x() * v.y() - from.y() * v.x()) / area,
                     b = (u.x() * from.y() - u.y() * from.x()) / area;
        return std::fabs(std::sqrt(a * a + b * b) - 1);
      } else {
        return kInfinity;
      }
    });
  }
  void check_flight(const Bounce& from, const Bounce& to) {
    const Vec2 centre = room_.walls.segment_slot(from.surface) != kNoSurface
                            ? from.point
                            : room_.walls.arc(from.surface).curve.centre;
    const bool inside = (from.point - centre).dot(from.normal) < 0;
    const bool curved = centre != from.point;
    const Root root = !curved ? Root::none : inside ? Root::first : Root::second;
    const OrbitStart start{{from.point, from.out}, {from.surface, root}};
    Kept kept(1);
    exact_.follow(std::span(&start, 1), 1, kept);
    if (kept.bounces[0].empty() || kept.bounces[0][0].surface != to.surface) {
      ++other_walls;
      return;
    }
    const Bounce& truth = kept.bounces[0][0];
    worst = std::max(
        worst, (truth.point - to.point).norm() * std::fabs(to.in.dot(to.normal)) / (1 + to.t));
  }
  const Closed& room_;
  const OrbitTracer& exact_;
  std::vector<std::optional<Bounce>> last_;
};

TEST(FastOrbits, StayOnTheirWallsAndMeetThoseOfTheExactFlight) {
  for (const Closed& room : rooms()) {
    const OrbitTracer exact(room.walls, room.materials);
    const std::vector<OrbitStart> starts = room.starts(100);
    Checked checked(room, exact, starts.size());
    const FlightCounts counts = FastOrbits(exact, true).follow(starts, 1000, checked);
    EXPECT_GE(checked.bounces, 99'000U) << room.name;
    EXPECT_EQ(checked.lost, 0U) << room.name;
    EXPECT_EQ(checked.other_walls, 0U) << room.name;
    EXPECT_LT(checked.worst, 4e-15) << room.name;
    EXPECT_LT(static_cast<double>(counts.exact), 1e-3 * static_cast<double>(counts.flights))
        << room.name;
  }
}

// Into corners, along walls and tangents: what lanes cannot tell is what the exact tracer says.
TEST(FastOrbits, LeaveWhatIsDoubtfulToTheExactTracer) {
  const Closed room = rooms()[1];
  const OrbitTracer exact(room.walls, room.materials);
  const std::vector<OrbitStart> starts = {{{{0.125, 0.125}, {-1, -1}}},
                                          {{{0.25, 0.125}, {0, 1}}},
                                          {{{0, 0.25}, {0, 1}}},
                                          {{{0, 0}, {1, 1}}},
                                          {{{0.125, 0.125}, {1, 1}}}};
  Kept fast(starts.size()), truth(starts.size());
  const FlightCounts counts = FastOrbits(exact, true).follow(starts, 1, fast);
  exact.follow(starts, 1, truth);
  EXPECT_EQ(counts.exact, 4U);
  EXPECT_EQ(fast.ends, truth.ends);
  for (std::size_t i = 0; i < starts.size(); ++i)
    ASSERT_EQ(fast.bounces[i].size(), truth.bounces[i].size()) << i;
}

TEST(FastOrbits, OfOpenRoomsLeaveOrAreAbsorbed) {
  Surfaces walls;
  walls.add(Circle{{2, 0}, 1});
  walls.add(Segment{{-3, -5}, {-3, 5}});
  const std::vector<Material> materials = {Material::mirror, Material::absorb};
  const OrbitTracer exact(walls, materials);
  const std::vector<OrbitStart> starts = {{{{0, 0}, {0, 2}}}, {{{0, 0}, {1, 0}}}};
  Kept kept(2);
  const FlightCounts counts = FastOrbits(exact, false).follow(starts, 5, kept);
  EXPECT_EQ(counts.exact, 0U);
  EXPECT_EQ(kept.ends, (std::vector{OrbitEnd::escape, OrbitEnd::absorbed}));
  ASSERT_EQ(kept.bounces[1].size(), 1U);
  EXPECT_EQ(kept.bounces[1][0].point, Vec2(1, 0));
}

TEST(FastOrbits, SayWhyARoomIsFollowedExactly) {
  Surfaces walls = ring({{0, 0}, {1, 0}, {1, 1}});
  walls.add(Bezier({0, 0}, {0.5, 1}, {1, 0}));
  const std::vector<Material> mirrors = all_mirrors(walls);
  const OrbitTracer exact(walls, mirrors);
  EXPECT_NE(FastOrbits(exact, true).obstacle().find("Bezier"), std::string::npos);
  const Surfaces box = ring({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  for (const Ellipse& curve :
       {Ellipse(Circle{{0.7, 0.6}, 0x1p-25}), Ellipse({0.5, 0.5}, {0.3, 0.1}, {-1e-7, 3e-7})}) {
    const Surfaces room = with(box, Arc{curve, Arc::Extent::whole, {0, 0}, {0, 0}});
    const std::vector<Material> all = all_mirrors(room);
    const OrbitTracer tracer(room, all);
    EXPECT_NE(FastOrbits(tracer, true).obstacle().find("too thin"), std::string::npos);
  }
}

// What joins the ends to the circle is met, which lanes know nothing of.
TEST(FastOrbits, EndWhereArcsEndOffTheirCurve) {
  const Surfaces room = with(ring({{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}),
                             Arc{Circle{{0, 0}, 1}, Arc::Extent::between, {3, 0}, {0, 3}});
  const std::vector<Material> mirrors = all_mirrors(room);
  const OrbitTracer exact(room, mirrors);
  const FastOrbits fast(exact, true);
  EXPECT_NE(fast.obstacle().find("off its curve"), std::string::npos);
}

// All of the room but for a notch of that depth lies on one side of a wall: a ray that grazes the notch
// crosses the line of the wall long before.
TEST(FastOrbits, ANotchIsMetHoweverShallow) {
  for (const double depth : {0x1p-31, 0x1p-40, 0x1p-47, 0x1p-49}) {
    const Surfaces walls = ring({{0, 0}, {1, 0}, {1, -depth}, {2, -depth}, {2, 1}, {0, 1}});
    const std::vector<Material> mirrors = all_mirrors(walls);
    const OrbitTracer exact(walls, mirrors);
    std::vector<OrbitStart> starts;
    for (int i = 0; i < 1000; ++i)
      starts.push_back(
          {{{0.1 + i * 0x1p-13, (1 + i % 97) * 0x1p-13}, {1.75, -(1 + i % 97) * 0x1p-13}}});
    Kept fast(starts.size()), truth(starts.size());
    FastOrbits(exact, true).follow(starts, 1, fast);
    exact.follow(starts, 1, truth);
    for (std::size_t i = 0; i < starts.size(); ++i) {
      ASSERT_EQ(fast.bounces[i].empty(), truth.bounces[i].empty()) << depth << ' ' << i;
      if (truth.bounces[i].empty()) continue;
      EXPECT_EQ(fast.bounces[i][0].surface, truth.bounces[i][0].surface) << depth << ' ' << i;
    }
  }
}

// An ellipse is the same with its half-diameters the other way round, and so are its normals.
TEST(FastOrbits, AnEllipseWhoseHalfDiametersTurnClockwiseKeepsItsRaysOut) {
  const Surfaces box = ring({{-8, -8}, {8, -8}, {8, 8}, {-8, 8}});
  const Ellipse curve({4, -1}, {1, -2}, {-3, 1});
  const Surfaces room = with(box, Arc{curve, Arc::Extent::between, {5, -3}, {1, 0}});
  const std::vector<Material> mirrors = all_mirrors(room);
  const OrbitTracer exact(room, mirrors);
  std::vector<OrbitStart> starts;
  for (int i = 0; i < 300; ++i)
    starts.push_back({{{-4, -2 + i * 0x1p-9}, {std::cos(0.02 * i), std::sin(0.02 * i)}}});
  Kept fast(starts.size()), truth(starts.size());
  FastOrbits(exact, true).follow(starts, 3, fast);
  exact.follow(starts, 3, truth);
  for (std::size_t i = 0; i < starts.size(); ++i) {
    ASSERT_EQ(fast.bounces[i].size(), truth.bounces[i].size()) << i;
    for (std::size_t k = 0; k < truth.bounces[i].size(); ++k) {
      EXPECT_EQ(fast.bounces[i][k].surface, truth.bounces[i][k].surface) << i;
      EXPECT_LT(truth.bounces[i][k].normal.dot(truth.bounces[i][k].in), 0) << i;
    }
  }
}

}  // namespace
}  // namespace flatray
