#include "anim/world.h"

#include <gtest/gtest.h>

#include "base/philox.h"
#include "geom/hit_interval.h"
#include "scenes.h"

namespace flatray {
namespace {

using namespace flatray::testing;

World world_of(const Scene& scene, unsigned frame = 1) {
  return build_world(scene, at(Timeline(scene, 0, frame), frame));
}

TEST(World, OutlinesKeepTheInputsEdgeNumbersAndOwners) {
  Scene scene = small_scene();
  add_box(scene, {2, 3});
  scene.entities[0].material = Material::mirror;
  const World world = world_of(scene);
  ASSERT_EQ(world.surfaces.size(), 4U);
  ASSERT_EQ(world.owners.size(), 4U);
  for (std::uint32_t i = 0; i < 4; ++i) {
    EXPECT_EQ(world.owners[i].edge, static_cast<std::int32_t>(i));
    EXPECT_EQ(world.owners[i].kind, SurfaceOwner::Kind::entity);
    EXPECT_EQ(world.owners[i].material, Material::mirror);
  }
  EXPECT_EQ(world.surfaces.segments[0].a, Vec2(2, 3));
  EXPECT_EQ(world.surfaces.segments[0].b, Vec2(3, 3));
}

TEST(World, EntitiesWithoutAMaterialAreSceneryThatRaysPass) {
  Scene scene = small_scene();
  add_box(scene, {2, 3});
  scene.entities[0].material.reset();
  EXPECT_EQ(world_of(scene).surfaces.size(), 0U);
}

TEST(World, CutsBetweenPiecesAreNoWalls) {
  Scene scene = small_scene();
  add_box(scene, {0, 0});
  // The unit square as two triangles, cut from (0, 0) to (1, 1).
  Shape& cut = scene.shapes[0];
  cut.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
  cut.begin = {0, 3, 6};
  cut.edges = {0, 1, -1, -1, 2, 3};
  const World world = world_of(scene);
  ASSERT_EQ(world.surfaces.size(), 4U);
  for (std::uint32_t i = 0; i < 4; ++i)
    EXPECT_EQ(world.owners[i].edge, static_cast<std::int32_t>(i));
}

TEST(World, EdgesThatTwoPiecesShareAreNoWalls) {
  Scene scene = small_scene();
  add_box(scene, {0, 0});
  // A row of three squares as an import gives them: every edge has its own number.
  Shape& row = scene.shapes[0];
  row = Shape{};
  for (int i = 0; i < 3; ++i) {
    const double x = i;
    for (const Vec2& vertex : {Vec2(x, 0), Vec2(x + 1, 0), Vec2(x + 1, 1), Vec2(x, 1)}) {
      row.edges.push_back(static_cast<std::int32_t>(row.vertices.size()));
      row.vertices.push_back(vertex);
    }
    row.begin.push_back(static_cast<std::uint32_t>(row.vertices.size()));
  }
  const World world = world_of(scene);
  std::vector<std::int32_t> edges;
  for (const SurfaceOwner& owner : world.owners) edges.push_back(owner.edge);
  EXPECT_EQ(edges, (std::vector<std::int32_t>{0, 2, 3, 4, 6, 8, 9, 10}));
}

TEST(World, EdgesThatPiecesCoverTwiceInOneDirectionStay) {
  Scene scene = small_scene();
  add_box(scene, {0, 0});
  Shape& twice = scene.shapes[0];
  const Shape once = twice;
  twice.vertices.insert(twice.vertices.end(), once.vertices.begin(), once.vertices.end());
  twice.edges.insert(twice.edges.end(), once.edges.begin(), once.edges.end());
  twice.begin.push_back(8);
  EXPECT_EQ(world_of(scene).surfaces.size(), 8U);
}

TEST(World, SegmentsAndCirclesAreTracedAndCrossingRingsAreNot) {
  Scene scene = small_scene();
  Shape shape;
  shape.segments = {{{0, 0}, {1, 0}}, {{1, 0}, {1, 1}}};
  shape.circles = {{{0, 0}, 2}};
  shape.crossing_rings = {{{0, 0}, {1, 1}, {1, 0}, {0, 1}}};
  scene.shapes = {shape};
  Entity entity;
  entity.at = {5, 5};
  entity.material = Material::mirror;
  scene.entities = {entity};
  const World world = world_of(scene);
  ASSERT_EQ(world.surfaces.size(), 3U);
  EXPECT_EQ(world.owners[1].edge, 1);
  EXPECT_EQ(world.owners[2].edge, kNoEdge);
  EXPECT_EQ(world.surfaces.arcs[0].curve.centre, Vec2(5, 5));
  EXPECT_EQ(world.surfaces.arcs[0].curve.u.x(), 2);
}

TEST(World, ChambersAndPillarsFollowTheEntities) {
  Scene scene = small_scene();
  add_box(scene, {0, 0});
  scene.shapes.push_back(box({0, 0}, {20, 10}));
  Chamber room;
  room.shape = 1;
  room.pillars.push_back({.name = "a",
                          .shape = 0,
                          .at = {2, 2},
                          .fill = {},
                          .stroke = {},
                          .where = {},
                          .copy_of = {}});
  room.pillars.push_back({.name = "b",
                          .shape = 0,
                          .at = {9, 9},
                          .material = Material::absorb,
                          .fill = {},
                          .stroke = {},
                          .where = {},
                          .copy_of = {}});
  scene.chambers = {room};
  const World world = world_of(scene);
  ASSERT_EQ(world.owners.size(), 16U);
  EXPECT_EQ(world.owners[4].kind, SurfaceOwner::Kind::chamber);
  EXPECT_EQ(world.owners[8].kind, SurfaceOwner::Kind::pillar);
  EXPECT_EQ(world.owners[15].pillar, 1U);
  EXPECT_EQ(world.owners[15].material, Material::absorb);
  EXPECT_EQ(world.surfaces.segments[8].a, Vec2(2, 2));
}

// Wherever a ring is carried and however it is turned, its walls share their ends bit for bit.
TEST(World, OutlinesAreWatertight) {
  const auto unit = [](std::uint64_t item, std::uint32_t draw) {
    return unit_double(random_bits(1, Stream::test, 0, item, draw));
  };
  for (std::uint64_t trial = 0; trial < 200; ++trial) {
    Scene scene = small_scene();
    const double reach = std::ldexp(1.0, static_cast<int>(trial % 40) - 10);
    add_box(scene, {reach * unit(trial, 0), -reach * unit(trial, 1)}, {unit(trial, 2), 0.1});
    scene.shapes[0] = polygon({{0, 0}, {1, 0.1}, {1.3, unit(trial, 3)}, {0.7, 1.9}, {-0.2, 1.1}});
    scene.entities[0].angle = 10 * unit(trial, 4);
    scene.camera.velocity = {0.3, 0.7};
    scene.camera.motion = CameraMotion::objects;
    const World world = world_of(scene, 4);
    const auto& walls = world.surfaces.segments;
    ASSERT_EQ(walls.size(), 5U);
    for (std::size_t i = 0; i < walls.size(); ++i)
      EXPECT_EQ(walls[i].b, walls[(i + 1) % walls.size()].a);
  }
}

TEST(World, EdgesThatVanishInTheDoublesAreLeftOutAndNothingOpens) {
  Scene scene = small_scene();
  add_box(scene, {0x1p53, 0});
  scene.shapes[0] = polygon({{0, 0}, {8, 0}, {8.25, 4}, {8, 8}, {0, 8}});
  const World world = world_of(scene);
  const auto& walls = world.surfaces.segments;
  EXPECT_EQ(walls.size(), 5U);
  scene.shapes[0] = polygon({{0, 0}, {8, 0}, {8.25, 0}, {8, 8}, {0, 8}});
  const World flat = world_of(scene);
  EXPECT_EQ(flat.surfaces.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(flat.surfaces.segments[i].b, flat.surfaces.segments[(i + 1) % 4].a);
}

World world_of_path(const ArcPath& path, const Vec2& place, double angle) {
  Scene scene = small_scene();
  add_box(scene, place);
  scene.entities[0].angle = angle;
  scene.shapes[0] = Shape{};
  scene.shapes[0].arc_paths.push_back(path);
  return world_of(scene);
}

// Two half circles of a capsule and its sides, in turn; they share the doubles they end at.
TEST(World, ACapsuleIsTwoArcsAndTwoSides) {
  const EllipseArc far{{2, 0}, {0, -1}, {1, 0}, 0, std::numbers::pi};
  const EllipseArc near{{0, 0}, {0, 1}, {-1, 0}, 0, std::numbers::pi};
  for (const double angle : {0.0, 0.7}) {
    const World world = world_of_path({{far, near}, true}, {5, 3}, angle);
    const Surfaces& walls = world.surfaces;
    ASSERT_EQ(walls.size(), 4U);
    ASSERT_EQ(walls.arcs.size(), 2U);
    for (std::uint32_t i = 0; i < 4; ++i) {
      EXPECT_EQ(walls.segment_slot(i) != kNoSurface, i % 2 == 1);
      EXPECT_EQ(world.owners[i].edge, static_cast<std::int32_t>(i));
    }
    EXPECT_EQ(walls.arcs[0].to, walls.segments[0].a);
    EXPECT_EQ(walls.segments[0].b, walls.arcs[1].from);
    EXPECT_EQ(walls.arcs[1].to, walls.segments[1].a);
    EXPECT_EQ(walls.segments[1].b, walls.arcs[0].from);
    EXPECT_TRUE(walls.arcs[0].curve.is_circle());  // in any pose
    EXPECT_EQ(walls.arcs[0].curve.u, Vec2(1, 0));
    if (angle == 0) {
      EXPECT_EQ(walls.arcs[0].from, Vec2(7, 2));
    }
  }
}

TEST(World, AnEllipseIsOneWallAndAFlatOneASegment) {
  const World world = world_of_path({{{{0, 0}, {3, 0}, {0, 2}}}, true}, {1, 1}, 0.3);
  ASSERT_EQ(world.surfaces.arcs.size(), 1U);
  EXPECT_EQ(world.surfaces.arcs[0].extent, Arc::Extent::whole);
  EXPECT_EQ(world.surfaces.size(), 1U);
  const World flat = world_of_path({{{{0, 0}, {3, 0}, {0, 0}}}, true}, {1, 1}, 0);
  ASSERT_EQ(flat.surfaces.segments.size(), 1U);
  EXPECT_EQ(flat.surfaces.segments[0].a, Vec2(-2, 1));
  EXPECT_EQ(flat.surfaces.segments[0].b, Vec2(4, 1));
}

// The sides of a sector meet in its corner, which is an arc that is a point and has no number.
TEST(World, ASectorIsAnArcAndTwoSides) {
  const EllipseArc outer{{0, 0}, {2, 0}, {0, 2}, 0, std::numbers::pi / 2};
  const EllipseArc corner{{0, 0}, {0, 0}, {0, 0}, std::numbers::pi / 2, -std::numbers::pi / 2};
  const World world = world_of_path({{outer, corner}, true}, {1, 1}, 0);
  ASSERT_EQ(world.surfaces.size(), 3U);
  EXPECT_EQ(world.surfaces.segments[0].b, Vec2(1, 1));
  EXPECT_EQ(world.surfaces.segments[1].a, Vec2(1, 1));
  EXPECT_EQ(world.owners[2].edge, 2);
}

// Products of their sizes are no doubles.
TEST(World, ArcsOfAnySizeAreOnTheSameSide) {
  for (const double v : {3.0, 2.0, -2.0}) {
    const auto of_size = [v](double size) {
      const EllipseArc arc{{0, 0}, {3 * size, 0}, {0, v * size}, 0.5, 3};
      return world_of_path({{arc}, false}, {0, 0}, 0).surfaces.arcs.at(0);
    };
    const Arc one = of_size(1);
    for (const double size : {0x1p-1000, 0x1p-570, 0x1p-530, 0x1p500, 0x1p900}) {
      const Arc arc = of_size(size);
      EXPECT_EQ(arc.from, Vec2(size * one.from)) << size;
      EXPECT_EQ(arc.to, Vec2(size * one.to)) << size;
    }
  }
}

}  // namespace
}  // namespace flatray
