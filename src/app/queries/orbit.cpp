#include "transport/orbit.h"

#include <fmt/core.h>

#include <numeric>

#include "app/query/query.h"
#include "app/report/report.h"
#include "geom/predicates.h"
#include "precise/certified_orbit.h"
#include "precise/proven_bounces.h"
#include "scene/outlines/lattice_cell.h"

namespace flatray::orbit_query {
namespace {

constexpr std::uint64_t kMostBounces = 1'000'000;  // an answer is one line in memory

// The walls of an orbit question, and how its answer numbers them.
struct QuestionRoom {
  Surfaces walls;  // those asked about; then the edges of the cell, then copies of discs
  std::vector<Material> materials;     // by surface
  std::vector<std::uint32_t> numbers;  // by surface: of a copy that of its disc
};

using Corners = std::vector<Vec2>;

const Vec2& corner(const Corners& cell, std::size_t i) { return cell[i % cell.size()]; }

// Whether every corner of a convex polygon turns one way.
bool turns(const Corners& cell, Sign way) {
  for (std::size_t i = 0; i < cell.size(); ++i)
    if (orientation(cell[i], corner(cell, i + 1), corner(cell, i + 2)) != way) return false;
  return true;
}

bool holds(const Corners& cell, const Vec2& point) {
  for (std::size_t i = 0; i < cell.size(); ++i)
    if (orientation(cell[i], corner(cell, i + 1), point) == Sign::negative) return false;
  return true;
}

Shape shape_of(const Corners& cell) {
  Shape shape;
  shape.vertices = cell;
  shape.begin.push_back(static_cast<std::uint32_t>(cell.size()));
  return shape;
}

// What is wrong with it as a cell; "" for nothing.
std::string fault_of(const Corners& cell) {
  if (turns(cell, Sign::negative)) return "is clockwise: say its corners the other way round";
  if (!turns(cell, Sign::positive)) return "is flat at a corner, or has one twice";
  const auto fault = cell_fault(shape_of(cell));
  return fault ? fault->message : "";
}

// Whether a wall that is no disc stands in the cell.
bool stands_in(const Corners& cell, const Segment& wall) {
  return holds(cell, wall.a) && holds(cell, wall.b);
}
template <class Curve>
bool stands_in(const Corners& cell, const Curve& wall) {
  const Bounds box = bounds_of(wall);
  return holds(cell, box.low) && holds(cell, box.high) &&
         holds(cell, {box.low.x(), box.high.y()}) && holds(cell, {box.high.x(), box.low.y()});
}

// Discs as pillars of a chamber, by which walls they are, with the copies of those across its
// walls.
struct Discs {
  Scene scene;
  Chamber chamber;
  std::vector<std::uint32_t> walls;

  Discs(const Corners& cell, const Surfaces& given) {
    scene.shapes.push_back(shape_of(cell));
    for (std::uint32_t i = 0; i < given.size(); ++i)
      if (const auto disc = given.visit(i, [](const auto& wall) { return whole_circle(wall); })) {
        Chamber::Pillar pillar;
        pillar.shape = static_cast<ShapeId>(scene.shapes.size());
        scene.shapes.emplace_back().circles.push_back(*disc);
        chamber.pillars.push_back(pillar);
        walls.push_back(i);
      }
    add_copies_of_discs(scene, chamber);
  }
  const Circle& circle(std::size_t i) const {
    return scene.shapes[chamber.pillars[i].shape].circles.front();
  }
};

void add_copies(const Discs& discs, const Corners& cell, Question& question, QuestionRoom& room) {
  const auto mistake = [&](std::size_t disc, const std::string& what) {
    question.mistake(fmt::format("walls[{}]", discs.walls[disc]), what);
  };
  const double depth = cell_depth(discs.scene.shapes.front());
  for (std::size_t i = 0; i < discs.chamber.pillars.size(); ++i) {
    const Chamber::Pillar& pillar = discs.chamber.pillars[i];
    const Circle& circle = discs.circle(i);
    if (!pillar.copy_of) {
      if (!pillar.across && !holds(cell, circle.centre)) mistake(i, "stands outside the cell");
      if (pillar.across && circle.radius > depth)
        mistake(i, "reaches over more cells than those that are looked at");
      continue;
    }
    for (std::size_t other = *pillar.copy_of + 1; other < discs.walls.size(); ++other)
      if (discs.circle(other).centre == circle.centre &&
          discs.circle(other).radius == circle.radius)
        mistake(other, fmt::format("is walls[{}] again, that of another cell: say it once",
                                   discs.walls[*pillar.copy_of]));
    room.walls.add(circle);
    room.materials.push_back(Material::mirror);
    room.numbers.push_back(discs.walls[*pillar.copy_of]);
  }
}

// Walls as they stand: all mirrors.
QuestionRoom plain_room(Surfaces walls) {
  QuestionRoom room{std::move(walls), {}, {}};
  room.materials.assign(room.walls.size(), Material::mirror);
  room.numbers.resize(room.walls.size());
  std::iota(room.numbers.begin(), room.numbers.end(), 0U);
  return room;
}

// Walls inside a cell of which opposite edges are the same: "cell":[[x,y],...], four or six
// corners. A whole circle that stands across its edges is copied to where it reaches in from other
// cells.
//
// Gives   mistakes of the question where the polygon is no such cell, counter-clockwise; where a
//         wall reaches out of it, for curves that are no whole circles by their box; where a disc
//         reaches farther than the copies that are made, or stands where another's copy does.
//         Exact, but for the box.
QuestionRoom periodic_room(Question& question, Surfaces walls) {
  const Corners cell = question.polygon("cell");
  QuestionRoom room = plain_room(std::move(walls));
  if (!question.sound()) return room;
  if (const std::string fault = fault_of(cell); !fault.empty()) {
    question.mistake("cell", fault);
    return room;
  }
  for (std::uint32_t i = 0; i < room.walls.size(); ++i)
    room.walls.visit(i, [&](const auto& wall) {
      if (!whole_circle(wall) && !stands_in(cell, wall))
        question.mistake(fmt::format("walls[{}]", i),
                         "reaches out of the cell, or its box does: only whole circles may");
    });
  const Discs discs(cell, room.walls);
  for (std::size_t i = 0; i < cell.size(); ++i) {
    room.numbers.push_back(room.walls.add(Segment{cell[i], corner(cell, i + 1)}));
    room.materials.push_back(Material::periodic);
  }
  add_copies(discs, cell, question, room);
  return room;
}

// Whether a point is in its cell or on the edge of it; without a cell all are. Exact.
bool is_in_cell(const QuestionRoom& room, const Vec2& point) {
  for (std::uint32_t i = 0; i < room.walls.size(); ++i)
    if (room.materials[i] == Material::periodic &&
        orientation(room.walls.segment(i).a, room.walls.segment(i).b, point) == Sign::negative)
      return false;
  return true;
}

// Of either kind of orbit: what is the same.
template <class Path>
Fields path(const QuestionRoom& room, const Path& orbit, const char* end) {
  Values numbers, points, cells;
  const PeriodicWalls periodic(room.walls, room.materials);
  for (const auto& bounce : orbit.bounces) {
    numbers.emplace_back(room.numbers[bounce.surface]);
    points.push_back(as_value(bounce.point));
    if (periodic.any()) cells.push_back(Values{bounce.cell.a, bounce.cell.b});
  }
  const bool escapes = orbit.end == OrbitEnd::escape;
  Fields fields{{"walls", std::move(numbers)},
                {"points", std::move(points)},
                {"end", end},
                {"out", escapes ? as_value(orbit.out) : JsonValue()}};
  if (orbit.end == OrbitEnd::corner) {
    Values corner_walls;
    for (const std::uint32_t wall : orbit.end_surfaces)
      corner_walls.emplace_back(room.numbers[wall]);
    fields.emplace_back("corner", as_value(orbit.end_point));
    fields.emplace_back("corner_walls", std::move(corner_walls));
  }
  if (!periodic.any()) return fields;
  fields.emplace_back("cells", std::move(cells));
  fields.emplace_back("lattice",
                      Values{as_value(periodic.lattice()[0]), as_value(periodic.lattice()[1])});
  return fields;
}

Fields in_doubles(const QuestionRoom& room, const Ray& ray, std::uint64_t bounces,
                  const Tracer* tracer) {
  const Orbit orbit =
      trace_orbit(room.walls, room.materials, ray, bounces, {CornerRule::stop, tracer});
  Fields fields = path(room, orbit, name(orbit.end));
  const bool exact = tracer == nullptr || tracer->exact;
  fields.emplace_back("certain", exact ? proven_bounces(room.walls, orbit, room.materials).bounces
                                       : std::uint64_t{0});
  return fields;
}

Fields certified(const QuestionRoom& room, const Ray& ray, std::uint64_t bounces,
                 Question& question) {
  const auto orbit =
      certified_orbit(room.walls, ray, bounces, {room.materials, question.precision().most_bits});
  if (!orbit) {
    question.mistake("precision", orbit.error().front().message);
    return {};
  }
  Fields fields = path(room, *orbit, orbit->decided ? name(orbit->end) : "undecided");
  fields.emplace_back("certain", std::uint64_t{orbit->bounces.size()});
  if (orbit->bits > 0) fields.emplace_back("bits", orbit->bits);
  if (orbit->rational) fields.emplace_back("rational", true);
  return fields;
}

Fields answer(Question& question) {
  const Ray ray = question.ray();
  Surfaces walls = question.walls("walls");
  const QuestionRoom room = question.has("cell") ? periodic_room(question, std::move(walls))
                                                 : plain_room(std::move(walls));
  const std::uint64_t bounces = question.whole("bounces");
  if (bounces > kMostBounces) question.mistake("bounces", "are a million at most");
  if (question.sound() && is_zero(ray.direction))
    question.mistake("direction", "is zero: an orbit needs somewhere to go");
  if (question.sound() && !is_in_cell(room, ray.origin))
    question.mistake("origin", "lies outside the cell");
  if (!question.sound()) return {};
  return question.precision().certified
             ? certified(room, ray, bounces, question)
             : in_doubles(room, ray, bounces, question.precision().tracer);
}

}  // namespace

extern const Query entry = {"orbit", "the bounces of a ray between mirrors", &answer};

}  // namespace flatray::orbit_query
