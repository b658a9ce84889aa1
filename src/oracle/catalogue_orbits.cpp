#include <cmath>

#include "oracle/catalogue_parts.h"

namespace flatray::oracle {
namespace {

using Orbits = std::vector<StiffOrbits>;
using End = StiffOrbits::End;

// Of one start.
StiffOrbits from(Surfaces walls, const Ray& start, std::uint64_t bounces, End end,
                 std::uint64_t count, std::uint64_t ordered = 0) {
  return {std::move(walls), {start}, bounces, end, count, ordered};
}

// In a convex room: nothing leaves, and the first `ordered` walls are those of many bits.
StiffOrbits in_room(const Ring& vertices, const Ray& start, std::uint64_t bounces,
                    std::uint64_t ordered) {
  return {ring_of(vertices), {start}, bounces, End::limit, bounces, ordered, vertices.size()};
}

StiffOrbits in_circle(const Ray& start, std::uint64_t bounces) {
  return from(walls_of(Circle{{0, 0}, 1}), start, bounces, End::limit, bounces);
}

// Walls y = 0 and through (0, 0) and (run, 1).
StiffOrbits in_wedge(double run, const Ray& start, std::uint64_t bounces, End end,
                     std::uint64_t count, std::uint64_t ordered) {
  return from(walls_of(Segment{{0, 0}, {1000 * run, 0}}, Segment{{0, 0}, {1000 * run, 1000}}),
              start, bounces, end, count, ordered);
}

Orbits parallel_entries() {
  return {in_wedge(10, {{1000, 1}, {-1, 0}}, 1000, End::escape, 31, 31),
          in_wedge(100, {{1e4, 1}, {-1, 0}}, 1000, End::escape, 314, 314),
          in_wedge(1000, {{1e5, 1}, {-1, 0}}, 10'000, End::escape, 3141, 200)};
}

// From far out at the polar angle alpha / 2: ceil(pi / alpha + 1/2) - 1.
Orbits any_entry() {
  Orbits all;
  for (const double run : {4.0, 37.0, 250.0}) {
    const double alpha = portable::atan2(1, run), theta = alpha / 2;
    const Vec2 out = on_circle(theta);
    const Vec2 start = 100 * run * out + 1e-3 * Vec2(-out.y(), out.x());
    const auto count = static_cast<std::uint64_t>(std::ceil((kTurn / 2 + theta) / alpha)) - 1;
    all.push_back(in_wedge(run, {start, -out}, 1000, End::escape, count, count));
  }
  return all;
}

Orbits three_mirrors() {
  Orbits all;
  for (const double y : {0.0, 0x1p-60, -0x1p-60}) {
    const std::uint64_t count = y == 0 ? 0 : 1;
    all.push_back(
        from(walls_of(Segment{{0, 0}, {-1, 2}}, Segment{{0, 0}, {-1, -2}}, Segment{{0, 0}, {2, 0}}),
             {{-4, y}, {1, 0}}, 10, y == 0 ? End::corner : End::escape, count, count));
  }
  return all;
}

Orbits few_directions() {
  const double h = 0x1.bb67ae8584caap+0;  // the square root of 3
  const std::vector<Ring> rooms = {
      {{0, 0}, {3, 0}, {3, 2}, {0, 2}}, regular(3), {{0, 0}, {1, 0}, {0, 1}},
      {{0, 0}, {h, 0}, {0, 1}},         regular(6), regular(5)};
  Orbits all;
  for (const Ring& room : rooms) {
    Vec2 middle(0, 0);
    for (const Vec2& vertex : room) middle += vertex / static_cast<double>(room.size());
    all.push_back(in_room(room, {middle, {0.71, 0.37}}, 1000, 200));
  }
  return all;
}

Orbits nested_circles() {
  StiffOrbits orbits{walls_of(Circle{{0, 0}, 1}, Circle{{0.5, 0}, 0.5}), {}, 50, End::any};
  for (const Vec2& way : regular(1000)) orbits.starts.push_back({{0, -0.75}, way});
  return {std::move(orbits)};
}

Orbits tangent_to_a_wall() {
  StiffOrbits orbits{ring_of({{-2, -1}, {2, -1}, {2, 3}, {-2, 3}}), {}, 50, End::any};
  orbits.room = 4;
  orbits.walls.add(Circle{{0, 0}, 1});
  orbits.starts = {{{0, 2.5}, {0, -1}}, {{-1.5, -1 + 0x1p-30}, {1, 0x1p-40}}};
  for (int k = 0; k < 400; ++k)  // at the touching point, and the doubles beside it
    orbits.starts.push_back({{-1.5, -0.75 - 0.0005 * k},
                             Vec2(0, -1 + (k % 9 - 4) * 0x1p-53) - Vec2(-1.5, -0.75 - 0.0005 * k)});
  return {std::move(orbits)};
}

Orbits thin_wall() {
  Orbits all;
  for (const double x : {0.0, 2.0})
    all.push_back(
        from(walls_of(Segment{{1, -1}, {1, 1}}, Segment{{1 + 0x1p-40, -1}, {1 + 0x1p-40, 1}}),
             {{x, 0}, {1 - x, 0.25}}, 3, End::escape, 1, 1));
  return all;
}

std::vector<StiffCase> in_polygons() {
  const Ring acute = {{0, 0}, {6, 0}, {6, 1}};
  const Vec2 first(5, 0), second(8.96, 6.72);
  return {
      of("C1", "diamond", "transport.StiffCases.C1Diamond",
         {in_room(kSquare, {{0.75, 0.25}, {1, 1}}, 1000, 1000)}),
      of("C2", "unfolding", "transport.StiffCases.C2Unfolding",
         {in_room(kSquare, {{0.125, 0.375}, {99, 70}}, 1000, 1000)}),
      of("C3", "wedge, parallel entry", "transport.StiffCases.C3WedgeParallelEntry",
         parallel_entries()),
      of("C4", "wedge, any entry", "transport.StiffCases.C4WedgeAnyEntry", any_entry()),
      of("C5", "wedge of a nanoradian", "transport.StiffCases.C5WedgeOfANanoradian",
         {in_wedge(1e9, {{1e11, 1}, {-1, 0}}, 1000, End::limit, 1000, 200)}),
      of("C6", "closed acute corner", "transport.StiffCases.C6ClosedAcuteCorner",
         {in_room(acute, {{5, 0.5}, {-5, -0.5 + 0x1p-54}}, 25, 25),
          in_room(acute, {{5, 0.5}, {-5, -0.5 - 0x1p-53}}, 25, 25)}),
      of("C7", "corner, exact", "transport.StiffCases.C7CornerExact",
         {{ring_of(kSquare), {{{0.25, 0.5}, {0.75, 0.5}}}, 3, End::corner, 0, 0, 4}}),
      of("C8", "corner, one ulp off", "transport.StiffCases.C8CornerOneUlpOff",
         {in_room(kSquare, {{0.25, 0.5}, {0.75, 0.5 + 0x1p-53}}, 10, 10),
          in_room(kSquare, {{0.25, 0.5}, {0.75, 0.5 - 0x1p-53}}, 10, 10)}),
      of("C9", "three mirrors", "transport.StiffCases.C9ThreeMirrors", three_mirrors()),
      of("C10", "Fagnano", "transport.StiffCases.C10Fagnano",
         {in_room({{0, 0}, {20, 0}, {10, 20}}, {{13, 4}, {3, 4}}, 1000, 1000)}),
      of("C11", "Fagnano 13-14-15", "transport.StiffCases.C11Fagnano131415",
         {in_room({{0, 0}, {14, 0}, {5, 12}}, {0.5 * first + 0.5 * second, second - first}, 301,
                  301)}),
      of("C15", "polygon gallery", "transport.StiffCases.C15PolygonGallery",
         {in_room(regular(1000), {{0.99, 0}, {0.1, 1}}, 2000, 50)}),
      of("C18", "few directions", "transport.StiffCases.C18Directions", few_directions()),
      of("C24", "conservation", "transport.StiffCases.C24Conservation",
         {in_room({{0, 0}, {5, -1}, {7, 3}, {3, 6}, {-1, 4}}, {{1, 1}, {0.6, 0.35}}, 10'000, 200)}),
      of("C27", "thin corridor", "transport.StiffCases.C27ThinCorridor",
         {in_room({{0, 0}, {1, 0}, {1, 0x1p-40}, {0, 0x1p-40}}, {{0.5, 0x1p-41}, {1, 0x1p-41}}, 100,
                  100)}),
      of("C28", "thin wall", "transport.StiffCases.C28ThinWall", thin_wall()),
      of("C31", "parallel mirrors", "transport.StiffCases.C31ParallelMirrors",
         {from(walls_of(Segment{{0, 0}, {1, 0}}, Segment{{0, 1}, {1, 1}}), {{0.3, 0.5}, {0, 1}},
               1000, End::limit, 1000, 1000)}),
      of("C32", "open chamber", "transport.StiffCases.C32OpenChamber",
         {from(walls_of(Segment{{0, 0}, {4, 0}}), {{2, 1}, {1, -1}}, 10, End::escape, 1, 1)}),
  };
}

std::vector<StiffCase> among_curves() {
  const Vec2 two = on_circle(2);
  return {
      of("C12", "circle, caustic", "transport.StiffCases.C12CircleCaustic",
         {in_circle({{0.5, 0.25}, {-1, 2}}, 10'000)}),
      of("C13", "circle, phase", "transport.StiffCases.C13CirclePhase",
         {in_circle({{0.5, 0.25}, {-1, 2}}, 1000)}),
      of("C14", "whispering gallery", "transport.StiffCases.C14WhisperingGallery",
         {in_circle({{0, 1 - 0x1p-20}, {1, 0}}, 10'000)}),
      of("C16", "naive circle trap", "transport.StiffCases.C16CircleKeepsTheSpeed",
         {in_circle({{1, 0}, two}, 10'000)}),
      of("C17", "ellipse", "transport.StiffCases.C17EllipseKeepsTheProductOfItsMomenta",
         {from(walls_of(Arc{Ellipse({0, 0}, {3, 0}, {0, 2}), Arc::Extent::whole, {0, 0}, {0, 0}}),
               {{1, 0.5}, {1, 1}}, 1000, End::limit, 1000)}),
      of("C25", "nested tangent circles", "transport.StiffCases.C25NestedTangentCircles",
         nested_circles()),
      of("C26", "circle tangent to a wall", "transport.StiffCases.C26NoLeakBetweenCircleAndWall",
         tangent_to_a_wall()),
  };
}

}  // namespace

std::vector<StiffCase> stiff_orbits() { return in_polygons() + among_curves(); }

}  // namespace flatray::oracle
