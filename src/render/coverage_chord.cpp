#include "render/coverage_chord.h"

#include <array>
#include <cmath>

#include "render/coverage_cell.h"

namespace flatray {
namespace {

// The edge passes through all rows of the pixel, or all its columns: so it crosses it wherever its
// line does.
bool spans(const ScanEdge& e, int column, int row) {
  const auto [left, right] = std::minmax(e.x_top, e.x_bottom);
  return (e.y_top <= row && row + 1.0 <= e.y_bottom) || (left <= column && column + 1.0 <= right);
}

// f(x, y) = dy (x - x_top) - dx (y - y_top) at the pixel's corners (0, 0), (1, 0), (0, 1), (1, 1):
// positive right of the edge.
struct Corners {
  std::array<Bounded, 4> f;
  std::array<Sign, 4> side;
  Bounded dx, dy;
};

std::optional<Corners> corners(const ScanEdge& e, int column, int row) {
  const Bounded x = Bounded(column) - Bounded(e.x_top), y = Bounded(row) - Bounded(e.y_top);
  const Bounded dx = Bounded(e.x_bottom) - Bounded(e.x_top);
  const Bounded dy = Bounded(e.y_bottom) - Bounded(e.y_top);
  const Bounded first = dy * x - dx * y;
  Corners all{{first, first + dy, first - dx, first + dy - dx}, {}, dx, dy};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::optional<Sign> side = all.f[i].sign();
    if (!side) return std::nullopt;
    all.side[i] = *side;
  }
  return all;
}

Bounded absolute(const Bounded& x) { return x.hi() < 0 ? -x : x; }

// Area of the part of the pixel on one side of the line, as a share of `whole`.
struct Part {
  Bounded area, whole;
};

Part part(const Corners& c, Sign side) {
  std::array<std::size_t, 4> inside{}, outside{};
  std::size_t count = 0, rest = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (c.side[i] == side)
      inside[count++] = i;
    else
      outside[rest++] = i;
  }
  const auto triangle = [&](std::size_t corner) {
    return Part{c.f[corner] * c.f[corner], absolute(Bounded(2) * c.dx * c.dy)};
  };
  switch (count) {
    case 0:
      return {0, 1};
    case 1:
      return triangle(inside[0]);
    case 2: {
      const bool side_by_side = (inside[0] ^ inside[1]) == 1;  // the line crosses both columns
      return {absolute(c.f[inside[0]] + c.f[inside[1]]),
              absolute(Bounded(2) * (side_by_side ? c.dx : c.dy))};
    }
    case 3: {
      const Part cut = triangle(outside[0]);
      // A corner on the line cuts nothing off, even where the line is one of the borders.
      if (c.side[outside[0]] == Sign::zero) return {1, 1};
      return {cut.whole - cut.area, cut.whole};
    }
    default:
      return {1, 1};
  }
}

}  // namespace

std::optional<std::uint32_t> bounded_steps(const Bounded& area, const Bounded& share) {
  const Bounded steps = area * Bounded(kFullCoverage);
  const double near = std::floor(steps.hi() / share.hi());
  for (const double step : {near, near - 1, near + 1}) {
    if (!(step >= 0 && step <= kFullCoverage)) continue;
    const std::optional<Sign> above = (steps - share * Bounded(step)).sign();
    if (!above || *above == Sign::negative) continue;
    if ((steps - share * Bounded(step + 1)).sign() == Sign::negative)
      return static_cast<std::uint32_t>(step);
  }
  return std::nullopt;
}

std::optional<std::uint32_t> chord_steps(const ScanEdge& edge, int winding, int column, int row,
                                         FillRule rule) {
  if (edge.y_top == edge.y_bottom || !spans(edge, column, row)) return std::nullopt;
  const std::optional<Corners> c = corners(edge, column, row);
  if (!c) return std::nullopt;
  // Just inside the corner, which a line through it may have on either side.
  const bool right_of_edge =
      c->side[0] == Sign::positive || (c->side[0] == Sign::zero && edge.x_bottom < edge.x_top);
  if (right_of_edge && edge.y_top <= row && row < edge.y_bottom) winding += edge.direction;
  const int right = right_of_edge ? winding : winding + edge.direction;
  const bool covers_right = covers(rule, right), covers_left = covers(rule, right - edge.direction);
  if (covers_right == covers_left) return covers_right ? kFullCoverage : 0;
  const Part covered = part(*c, covers_right ? Sign::positive : Sign::negative);
  return bounded_steps(covered.area, covered.whole);
}

}  // namespace flatray
