#pragma once
#include <cmath>
#include <numbers>
#include <string>

#include "base/philox.h"
#include "trace/rays.h"
#include "trace/surfaces.h"

namespace bench {

/// Uniform draws of one scene or set of rays, in order.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : seed_(seed) {}
  double between(double low, double high) {
    const auto bits = flatray::random_bits(seed_, flatray::Stream::experiment, 0, next_++);
    return low + (high - low) * flatray::unit_double(bits);
  }

 private:
  std::uint64_t seed_, next_ = 0;
};

/// How the polygons of a scene lie: radius in cells of the jittered grid, and the power p of
/// x -> W (x / W)^p that moves their centres (their radius shrinks with their cell).
struct Layout {
  enum class Curve { circle, arc, bezier };
  std::string name;
  double radius, power;
  double curved = 0;  ///< of walls without polygons the share of these curves; others are segments
  Curve curve = Curve::circle;
};
inline const Layout kUniform{"uniform", 0.2, 1}, kSparse{"sparse", 0.03, 1},
    kPower2{"power 2", 0.2, 2}, kPower6{"power 6", 0.2, 6};
/// Goal S16: of walls one in each cell half are curves, or all.
inline const Layout kCurved[] = {{"half circles", 0.2, 1, 0.5},
                                 {"circles", 0.2, 1, 1},
                                 {"half arcs", 0.2, 1, 0.5, Layout::Curve::arc},
                                 {"arcs", 0.2, 1, 1, Layout::Curve::arc},
                                 {"half Beziers", 0.2, 1, 0.5, Layout::Curve::bezier},
                                 {"Beziers", 0.2, 1, 1, Layout::Curve::bezier}};

/// Walls in a square room [0, side]^2.
struct Room {
  flatray::Surfaces walls;
  double side;
};

inline void add_ring(flatray::Surfaces& walls, const std::vector<flatray::Vec2>& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    walls.add(flatray::Segment{ring[i], ring[(i + 1) % ring.size()]});
}

inline flatray::Vec2 direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// A curve of any direction, or a segment.
inline void add_curve(const Layout& layout, const flatray::Vec2& at, Draws& draw,
                      flatray::Surfaces& walls) {
  using flatray::Vec2;
  const double turn = draw.between(0, 2 * std::numbers::pi), r = layout.radius;
  const auto point = [&](double angle, double radius) -> Vec2 {
    return at + radius * direction(turn + angle);
  };
  if (draw.between(0, 1) >= layout.curved) {
    walls.add(flatray::Segment{point(0, r), point(std::numbers::pi, r)});
  } else if (layout.curve == Layout::Curve::circle) {
    walls.add(flatray::Circle{at, r});
  } else if (layout.curve == Layout::Curve::arc) {
    walls.add(flatray::Arc{flatray::Circle{at, r}, flatray::Arc::Extent::between, point(0, r),
                           point(draw.between(1, 5), r)});
  } else {
    walls.add(flatray::Bezier(point(0, r), point(1, draw.between(0.5, 1.5) * r),
                              point(2, draw.between(0.5, 1.5) * r), point(3, r)));
  }
}

/// `count` walls, but for at most two: the four of the room, and convex polygons of 3 to 8 edges, one in each cell
/// of a jittered grid; where walls are curved, one wall in each such cell.
inline Room room(std::size_t count, const Layout& layout, std::uint64_t seed = 1) {
  Draws draw(seed);
  const double a_cell = layout.curved > 0 ? 1 : 5.5,
               cells_wanted = static_cast<double>(count > 4 ? count - 4 : 1) / a_cell;
  const auto cells = static_cast<int>(std::ceil(std::sqrt(cells_wanted)));
  Room made{{}, static_cast<double>(cells)};
  add_ring(made.walls, {{0, 0}, {made.side, 0}, {made.side, made.side}, {0, made.side}});
  const auto moved = [&](double x) { return made.side * std::pow(x / made.side, layout.power); };
  const auto shrink = [&](double x) {
    return layout.power * std::pow(x / made.side, layout.power - 1);
  };
  const std::size_t least = layout.curved > 0 ? 1 : 3;
  for (int cell = 0; cell < cells * cells && made.walls.size() + least <= count; ++cell) {
    const double keep = layout.radius;
    const flatray::Vec2 at(cell % cells + draw.between(keep, 1 - keep),
                           cell / cells + draw.between(keep, 1 - keep));
    if (layout.curved > 0) {
      add_curve(layout, at, draw, made.walls);
      continue;
    }
    const flatray::Vec2 centre(moved(at.x()), moved(at.y()));
    const double radius = layout.radius * std::min(shrink(at.x()), shrink(at.y()));
    const auto left = static_cast<int>(count - made.walls.size());
    const int edges = std::min(3 + static_cast<int>(draw.between(0, 6)), left);
    const double turn = draw.between(0, 2 * std::numbers::pi);
    std::vector<flatray::Vec2> ring;
    for (int k = 0; k < edges; ++k) {
      const double angle = turn + 2 * std::numbers::pi * k / edges;
      ring.push_back(centre + radius * direction(angle));
    }
    add_ring(made.walls, ring);
  }
  return made;
}

/// Any origin, any direction.
inline flatray::RayBatch random_rays(std::size_t count, double side, std::uint64_t seed) {
  Draws draw(seed);
  flatray::RayBatch rays;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = draw.between(0, side), y = draw.between(0, side);
    rays.add({{x, y}, direction(draw.between(0, 2 * std::numbers::pi))});
  }
  return rays;
}

/// From one point, by rising angle.
inline flatray::RayBatch fan(std::size_t count, double side) {
  flatray::RayBatch rays;
  for (std::size_t i = 0; i < count; ++i) {
    const double turn = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    rays.add({{0.51 * side, 0.49 * side}, direction(2 * std::numbers::pi * turn)});
  }
  return rays;
}

/// One direction, from a lattice of pixel centres, row by row.
inline flatray::RayBatch pixel_grid(std::size_t count, double side) {
  const auto rows = static_cast<std::size_t>(std::sqrt(static_cast<double>(count)));
  flatray::RayBatch rays;
  for (std::size_t i = 0; i < count; ++i) {
    const double step = side / static_cast<double>(rows);
    const flatray::Vec2 at(static_cast<double>(i % rows) + 0.5,
                           static_cast<double>(i / rows % rows) + 0.5);
    rays.add({step * at, direction(0.3)});
  }
  return rays;
}

}  // namespace bench
