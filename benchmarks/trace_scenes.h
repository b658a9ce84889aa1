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
  std::string name;
  double radius, power;
  bool discs = false;  ///< circles, where else polygons are
};
inline const Layout kUniform{"uniform", 0.2, 1}, kSparse{"sparse", 0.03, 1},
    kPower2{"power 2", 0.2, 2}, kPower6{"power 6", 0.2, 6}, kDiscs{"discs", 0.2, 1, true};

/// Walls in a square room [0, side]^2.
struct Room {
  flatray::Surfaces walls;
  double side;
};

inline void add_ring(flatray::Surfaces& walls, const std::vector<flatray::Vec2>& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    walls.add(flatray::Segment{ring[i], ring[(i + 1) % ring.size()]});
}

/// `count` segments, but for at most two: the four walls of the room, and convex polygons of 3 to 8
/// edges, one in each cell of a jittered grid; of discs a circle in each such cell.
inline Room room(std::size_t count, const Layout& layout, std::uint64_t seed = 1) {
  Draws draw(seed);
  const auto cells =
      static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count > 4 ? count - 4 : 1) / 5.5)));
  Room made{{}, static_cast<double>(cells)};
  add_ring(made.walls, {{0, 0}, {made.side, 0}, {made.side, made.side}, {0, made.side}});
  const auto moved = [&](double x) { return made.side * std::pow(x / made.side, layout.power); };
  const auto shrink = [&](double x) {
    return layout.power * std::pow(x / made.side, layout.power - 1);
  };
  for (int cell = 0; cell < cells * cells && made.walls.size() + 3 <= count; ++cell) {
    const double keep = layout.radius;
    const flatray::Vec2 at(cell % cells + draw.between(keep, 1 - keep),
                           cell / cells + draw.between(keep, 1 - keep));
    const flatray::Vec2 centre(moved(at.x()), moved(at.y()));
    const double radius = layout.radius * std::min(shrink(at.x()), shrink(at.y()));
    if (layout.discs) {
      made.walls.add(flatray::Circle{centre, radius});
      continue;
    }
    const auto left = static_cast<int>(count - made.walls.size());
    const int edges = std::min(3 + static_cast<int>(draw.between(0, 6)), left);
    const double turn = draw.between(0, 2 * std::numbers::pi);
    std::vector<flatray::Vec2> ring;
    for (int k = 0; k < edges; ++k) {
      const double angle = turn + 2 * std::numbers::pi * k / edges;
      ring.push_back(centre + radius * flatray::Vec2(std::cos(angle), std::sin(angle)));
    }
    add_ring(made.walls, ring);
  }
  return made;
}

inline flatray::Vec2 direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

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
