#include "app/query/periodic_cell.h"

#include <fmt/core.h>

#include <array>
#include <map>
#include <numeric>

#include "geom/predicates.h"
#include "scene/outlines/lattice_cell.h"

namespace flatray {
namespace {

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
  const auto numbers_of = [](const Circle& circle) {
    return std::array{circle.centre.x(), circle.centre.y(), circle.radius};
  };
  std::map<std::array<double, 3>, std::vector<std::size_t>> given;
  for (std::size_t i = 0; i < discs.walls.size(); ++i)
    given[numbers_of(discs.circle(i))].push_back(i);
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
    if (const auto same = given.find(numbers_of(circle)); same != given.end())
      for (const std::size_t other : same->second)
        if (other > *pillar.copy_of)
          mistake(other, fmt::format("is walls[{}] again, that of another cell: say it once",
                                     discs.walls[*pillar.copy_of]));
    room.walls.add(circle);
    room.materials.push_back(Material::mirror);
    room.numbers.push_back(discs.walls[*pillar.copy_of]);
  }
}

}  // namespace

QuestionRoom plain_room(Surfaces walls) {
  QuestionRoom room{std::move(walls), {}, {}};
  room.materials.assign(room.walls.size(), Material::mirror);
  room.numbers.resize(room.walls.size());
  std::iota(room.numbers.begin(), room.numbers.end(), 0U);
  return room;
}

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

bool is_in_cell(const QuestionRoom& room, const Vec2& point) {
  for (std::uint32_t i = 0; i < room.walls.size(); ++i)
    if (room.materials[i] == Material::periodic &&
        orientation(room.walls.segment(i).a, room.walls.segment(i).b, point) == Sign::negative)
      return false;
  return true;
}

}  // namespace flatray
