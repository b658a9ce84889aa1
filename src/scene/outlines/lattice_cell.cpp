#include "scene/outlines/lattice_cell.h"

#include <fmt/core.h>

#include <array>
#include <cmath>

#include "base/number_text.h"
#include "geom/error_free.h"
#include "scene/part_counts.h"

namespace flatray {
namespace {

bool is_one_polygon(const Shape& shape) {
  const std::size_t corners = shape.vertices.size();
  return (corners == 4 || corners == 6) && part_counts(shape) == PartCounts{.pieces = 1};
}

// Whether two corners have the middle of two others, and by how much not.
std::array<double, 2> apart(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  std::array<double, 2> off{};
  for (const int axis : {0, 1}) {
    const DoubleDouble one = two_sum(a[axis], b[axis]), other = two_sum(c[axis], d[axis]);
    off[static_cast<std::size_t>(axis)] = (one.hi - other.hi) + (one.lo - other.lo);
  }
  return off;
}

// How far inside an edge a place lies.
double depth_in(const Shape& cell, std::size_t i, const Vec2& place) {
  const Vec2 &a = cell.vertices[i], &b = cell.vertices[(i + 1) % cell.vertices.size()];
  const Vec2 edge = b - a;
  return cross(edge, Vec2(place - a)) / std::sqrt(edge.dot(edge));
}
// The least of all edges.
double least_depth(const Shape& cell, const Vec2& place) {
  double least = kInfinity;
  for (std::size_t i = 0; i < cell.vertices.size(); ++i)
    least = std::min(least, depth_in(cell, i, place));
  return least;
}

// x + n (b - a) + m (d - c), nearly without error before it is rounded.
double shifted(double x, int n, double a, double b, int m, double c, double d) {
  DoubleDouble sum{x, 0};
  const auto add = [&](int times, double y) {
    for (int i = 0; i < std::abs(times); ++i) {
      const DoubleDouble next = two_sum(sum.hi, times < 0 ? -y : y);
      sum = two_sum(next.hi, next.lo + sum.lo);
    }
  };
  add(n, b);
  add(-n, a);
  add(m, d);
  add(-m, c);
  return sum.hi;
}

// The wall opposite edge 1 is as far back as cell (1, 0) is away, that of edge 2 as cell (0, 1).
Lattice lattice_of(const Shape& cell) {
  const std::vector<Vec2>& at = cell.vertices;
  const std::size_t half = at.size() / 2;
  return {{at[(2 + half) % at.size()], at[1]}, {at[(3 + half) % at.size()], at[2]}};
}

}  // namespace

Vec2 Lattice::moved(const Vec2& place, int n, int m) const {
  const auto at = [&](int axis) {
    return shifted(place[axis], n, a.a[axis], a.b[axis], m, b.a[axis], b.b[axis]);
  };
  return {at(0), at(1)};
}

std::optional<CellFault> cell_fault(const Shape& shape) {
  if (!is_one_polygon(shape))
    return CellFault{"walls that are not a polygon of four or six corners cannot be periodic",
                     "write shape = { box = { min = [0, 0], max = [1, 1] } }, or cell = { a = [1, "
                     "0], b = [0.5, 1] }"};
  const std::vector<Vec2>& at = shape.vertices;
  if (!box_about(at).size().allFinite())
    return CellFault{"a cell that is wider than the largest double cannot be periodic",
                     "make it smaller"};
  const std::size_t half = at.size() / 2;
  for (std::size_t i = 1; i < half; ++i) {
    const auto off = apart(at[i], at[i + half], at[0], at[half]);
    if (off[0] == 0 && off[1] == 0) continue;
    const auto text = [](const Vec2& point) {
      return fmt::format("({}, {})", number_text(point.x()), number_text(point.y()));
    };
    return CellFault{
        fmt::format(
            "walls of which opposite ones are not the same cannot be periodic: the corner {} "
            "is ({}, {}) off where {} asks for it",
            text(at[i + half]), number_text(off[0]), number_text(off[1]), text(at[i])),
        "corners must lie opposite each other about one point, as those of cell = { a = [1, 0], b "
        "= [0.5, 1] } do"};
  }
  return std::nullopt;
}

double cell_depth(const Shape& cell) {
  const std::size_t half = cell.vertices.size() / 2;
  double least = kInfinity;
  for (std::size_t i = 0; i < half; ++i)
    least = std::min(least, depth_in(cell, i, cell.vertices[(i + half) % (2 * half)]));
  return least;
}

void add_copies_of_discs(Scene& scene, Chamber& chamber) {
  const Shape cell = scene.shapes[chamber.shape];
  const Lattice lattice = lattice_of(cell);
  // Copies that only touch the cell cost little; none that reaches in may be missing for rounding.
  constexpr double kGenerous = 1 + 0x1p-30;
  const std::size_t count = chamber.pillars.size();
  for (std::size_t i = 0; i < count; ++i) {
    Chamber::Pillar pillar = chamber.pillars[i];
    const Shape disc = scene.shapes[pillar.shape];
    if (part_counts(disc) != PartCounts{.circles = 1}) continue;
    const double radius = disc.circles.front().radius;
    const Vec2 local = disc.circles.front().centre;
    if (pillar.angle != 0 && !local.isZero(0)) continue;
    // Copies are rounded once; of centre and place one that is 0 stays it.
    const bool in_shape = pillar.at.isZero(0) || !local.isZero(0);
    const Vec2 centre = pillar.at + local;
    const double depth = least_depth(cell, centre);
    if (!(depth < radius && depth > -radius)) continue;
    pillar.across = true;
    pillar.copy_of = static_cast<std::uint32_t>(i);
    chamber.pillars[i].across = true;
    if (in_shape) {
      pillar.at = {0, 0};
      pillar.angle = 0;  // which would turn the centre of the copy
    }
    for (int n = -2; n <= 2; ++n)
      for (int m = -2; m <= 2; ++m) {
        const Vec2 there = lattice.moved(centre, n, m);
        if ((n == 0 && m == 0) || !(least_depth(cell, there) > -kGenerous * radius)) continue;
        if (in_shape) {
          Shape moved = disc;
          moved.circles.front().centre = there;
          pillar.shape = static_cast<ShapeId>(scene.shapes.size());
          scene.shapes.push_back(std::move(moved));
        } else {
          pillar.at = there;
        }
        chamber.pillars.push_back(pillar);
      }
  }
}

}  // namespace flatray
