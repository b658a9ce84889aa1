#pragma once
#include <array>
#include <cstdint>
#include <vector>

namespace flatray::oracle {

/// A number drawn evenly between two, anew for every ray or way.
struct EvenRange {
  double low = 0, high = 0;
};

/// Lamps and straight walls, in the coordinates and words of HQZ: y down, degrees clockwise.
struct FlatScene {
  struct Lamp {
    double power = 1;
    std::array<double, 3> rgb{1, 1, 1};
    EvenRange x{}, y{}, polar_angle{}, polar_distance{}, ray_angle{};
  };
  struct Wall {
    EvenRange x{}, y{}, dx{}, dy{};
    double scattered = 0, through = 0, mirrored = 0;  ///< parts of the light; the rest is absorbed
    /// Degrees of the mirror's normal at its beginning, and how many more at its end.
    bool has_normal = false;
    EvenRange normal{}, turn{};
  };
  std::vector<Lamp> lamps;
  std::vector<Wall> walls;
  double left = 0, top = 0, width = 1, height = 1;  ///< of the window
};

/// Light of each pixel, red, green and blue, row by row from the top: the length of all paths in it,
/// times the power that each carries, over its area. As the engine's fluence, and by nothing of it:
/// independent random numbers, every wall looked at, doubles without bounds, all light of one lamp in
/// its own colour.
///
/// Gives   every ray up to 1000 walls.
/// Error   of chance, 1 / sqrt(rays). Rays within rounding of a corner go either way; so do those that
///         have left one of two walls that lie on one another.
/// Cost    10 ns a wall and way, and 5 ns a pixel crossed.
struct FlatLight {
  std::vector<double> rgb;
  std::uint64_t ways = 0;  ///< from wall to wall
  /// Over all pixels.
  std::array<double, 3> mean() const;
};
FlatLight trace_flat(const FlatScene& scene, int width_px, int height_px, std::uint64_t rays,
                     std::uint64_t seed);

}  // namespace flatray::oracle
