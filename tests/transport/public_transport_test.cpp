// What <flatray/transport.h> gives is what trace_orbits gives, bit for bit.
#include <gtest/gtest.h>

#include <limits>

#include "base/philox.h"
#include "flatray/transport.h"
#include "transport/orbit.h"

namespace flatray {
namespace {

using Numbers = std::vector<double>;

double drawn(std::uint64_t item, std::uint32_t which) {
  return unit_double(random_bits(23, Stream::test, 0, item, which));
}

void expect_fault(api::Status status, api::Fault fault, std::size_t entry = 0) {
  EXPECT_EQ(status.fault, fault) << api::words(status.fault);
  EXPECT_EQ(status.entry, entry);
}

bool same(const api::Bounce& a, const Bounce& b) {
  return a.wall == b.surface && a.x == b.point.x() && a.y == b.point.y() && a.t == b.t &&
         a.path_length == b.path_length && a.normal_x == b.normal.x() &&
         a.normal_y == b.normal.y() && a.direction_x == b.out.x() && a.direction_y == b.out.y();
}

// A square with a round pillar; a quarter of the rays set off along diagonals into its corners.
struct Chamber {
  Numbers x{0, 8, 8, 0}, y{0, 0, 8, 8};
  std::vector<Ray> starts;
  Numbers ox, oy, dx, dy;

  explicit Chamber(std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i) {
      const double place = 3 * drawn(i, 0);
      const Ray ray = i % 4 == 0
                          ? Ray{{place, place}, {-1, -1}}
                          : Ray{{place, 8 * drawn(i, 1)}, {drawn(i, 2) - 0.5, drawn(i, 3) - 0.5}};
      starts.push_back(ray);
      ox.push_back(ray.origin.x()), oy.push_back(ray.origin.y());
      dx.push_back(ray.direction.x()), dy.push_back(ray.direction.y());
    }
  }
  api::Rays rays() const { return {ox, oy, dx, dy}; }
  api::Walls walls() const {
    api::Walls walls;
    EXPECT_TRUE(walls.add_ring(x, y));
    EXPECT_TRUE(walls.add_circles(Numbers{6}, Numbers{4}, Numbers{1}));
    return walls;
  }
  Surfaces surfaces() const {
    Surfaces walls;
    for (std::size_t i = 0; i < 4; ++i)
      walls.add(Segment{{x[i], y[i]}, {x[(i + 1) % 4], y[(i + 1) % 4]}});
    walls.add(Circle{{6, 4}, 1});
    return walls;
  }
};

TEST(PublicTransport, OrbitsAreThoseOfTheModule) {
  const Chamber chamber(400);
  const Surfaces surfaces = chamber.surfaces();
  for (const bool black : {false, true})
    for (const CornerRule corners : {CornerRule::stop, CornerRule::back}) {
      std::vector<Material> materials(surfaces.size(), Material::mirror);
      api::Room room(chamber.walls(), static_cast<api::CornerRule>(corners));
      if (black) {
        materials[2] = Material::absorb;
        ASSERT_TRUE(room.absorb(std::vector<std::uint32_t>{2}));
      }
      const auto wanted = trace_orbits(surfaces, materials, chamber.starts, 40, {corners});
      std::vector<api::Orbit> orbits;
      std::vector<api::Bounce> bounces;
      ASSERT_TRUE(room.orbits(chamber.rays(), 40, orbits, bounces));
      ASSERT_EQ(orbits.size(), wanted.size());
      std::size_t total = 0;
      for (std::size_t i = 0; i < orbits.size(); ++i) {
        const api::Orbit& orbit = orbits[i];
        ASSERT_EQ(orbit.begin, total);
        ASSERT_EQ(orbit.end - orbit.begin, wanted[i].bounces.size());
        ASSERT_EQ(orbit.reason, static_cast<api::OrbitEnd>(wanted[i].end));
        ASSERT_EQ(Vec2(orbit.out_x, orbit.out_y), wanted[i].out);
        ASSERT_EQ(Vec2(orbit.x, orbit.y), wanted[i].end_point);
        for (std::size_t k = orbit.begin; k < orbit.end; ++k)
          ASSERT_TRUE(same(bounces[k], wanted[i].bounces[k - orbit.begin])) << i;
        total = orbit.end;
      }
      EXPECT_EQ(bounces.size(), total);
      EXPECT_GT(total, 500U);
    }
}

TEST(PublicTransport, MistakesAreToldAndChangeNothing) {
  using api::Fault;
  const Chamber chamber(3);
  api::Room room(chamber.walls());
  std::vector<api::Orbit> orbits(7);
  std::vector<api::Bounce> bounces(5);
  expect_fault(room.absorb(std::vector<std::uint32_t>{0, 5}), Fault::no_such, 1);
  const Numbers one(3, 1), zero = {1, 0, 1}, short_one = {1};
  const Numbers bad = {1, 1, std::numeric_limits<double>::quiet_NaN()};
  expect_fault(room.orbits({one, one, zero, zero}, 1, orbits, bounces), Fault::direction, 1);
  expect_fault(room.orbits({one, bad, one, one}, 1, orbits, bounces), Fault::not_finite, 2);
  expect_fault(room.orbits({one, one, one, short_one}, 1, orbits, bounces), Fault::sizes);
  EXPECT_EQ(orbits.size(), 7U);
  EXPECT_EQ(bounces.size(), 5U);
  ASSERT_TRUE(room.orbits({one, one, one, one}, 1, orbits, bounces));
  EXPECT_EQ(orbits[0].reason, api::OrbitEnd::corner);  // along the diagonal, past the pillar

  const api::Room taken = std::move(room);
  EXPECT_EQ(taken.walls(), 5U);
  ASSERT_TRUE(room.orbits({one, one, one, one}, 1, orbits, bounces));  // NOLINT
  EXPECT_EQ(orbits[2].reason, api::OrbitEnd::escape);
  EXPECT_TRUE(bounces.empty());
}

// Of y = x^2 / 4, whose focus is (0, 1), the tangents at x = 2 and -2 are diagonals.
TEST(PublicTransport, AParabolaSendsWhatComesAlongItsAxisThroughItsFocus) {
  api::Walls walls;
  ASSERT_TRUE(walls.add_beziers(2, Numbers{-4, 0, 4}, Numbers{4, -4, 4}));
  const api::Room room(std::move(walls));
  std::vector<api::Orbit> orbits;
  std::vector<api::Bounce> bounces;
  ASSERT_TRUE(room.orbits({Numbers{2}, Numbers{5}, Numbers{0}, Numbers{-1}}, 9, orbits, bounces));
  ASSERT_EQ(bounces.size(), 2U);
  EXPECT_EQ(orbits[0].reason, api::OrbitEnd::escape);
  EXPECT_EQ((Numbers{bounces[0].x, bounces[0].y, bounces[1].x, bounces[1].y}),
            (Numbers{2, 1, -2, 1}));
  EXPECT_EQ((Numbers{bounces[0].direction_x, bounces[0].direction_y}), (Numbers{-1, 0}));
  EXPECT_EQ((Numbers{orbits[0].out_x, orbits[0].out_y, bounces[1].path_length}),
            (Numbers{0, 1, 8}));
}

}  // namespace
}  // namespace flatray
