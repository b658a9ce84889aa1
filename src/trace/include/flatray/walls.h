#pragma once
#include <cstdint>
#include <limits>
#include <span>

#include "flatray/owned.h"
#include "flatray/status.h"

namespace flatray::api {

/// No wall: of a ray that meets none, or has left none.
inline constexpr std::uint32_t kNoWall = 0xffffffffU;
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Walls, numbered from 0 in the order in which they are added. All are closed: their ends belong to
/// them.
///
/// Units   world units; any finite doubles, which are taken as they are.
/// Error   `sizes`, `not_finite`, `full`, and what each function names. The entry is the place in the
///         arrays.
/// Owns    copies of all that is added; a copy of it is a copy of all. Moved from, it is empty.
/// Threads one at a time while something is added or it is moved; any number that only read.
class Walls {
 public:
  Walls();
  Walls(const Walls& other);
  Walls(Walls&& other) noexcept;
  Walls& operator=(Walls other) noexcept;
  ~Walls();

  /// Segments from (ax, ay) to (bx, by). One without length is a point.
  Status add_segments(std::span<const double> ax, std::span<const double> ay,
                      std::span<const double> bx, std::span<const double> by);
  /// The sides of a polygon of any form, one from each vertex to the next and the last back to the
  /// first. Error   `empty`.
  Status add_ring(std::span<const double> x, std::span<const double> y);
  /// Circles, met from inside and outside. Radius 0 is a point. Error   `radius`.
  Status add_circles(std::span<const double> x, std::span<const double> y,
                     std::span<const double> radius);
  /// Ellipses: the points (x, y) + a (ux, uy) + b (vx, vy) with a^2 + b^2 = 1, by any two conjugate
  /// half-diameters. Error   `degenerate`: half-diameters that are parallel, exactly.
  Status add_ellipses(std::span<const double> x, std::span<const double> y,
                      std::span<const double> ux, std::span<const double> uy,
                      std::span<const double> vx, std::span<const double> vy);
  /// Arcs of circles, counter-clockwise from the direction in which (from_x, from_y) lies from the
  /// centre to that of (to_x, to_y). What lies between such a point and the circle, on the line to the
  /// centre, belongs to the arc, so that walls that share the point leave no gap.
  /// Error   `radius`; `degenerate`: radius 0, a point that is the centre, or both in one direction.
  Status add_arcs(std::span<const double> x, std::span<const double> y,
                  std::span<const double> radius, std::span<const double> from_x,
                  std::span<const double> from_y, std::span<const double> to_x,
                  std::span<const double> to_y);
  /// Bezier curves of degree 2, which are arcs of parabolas, or 3: curve i has the control points from
  /// (degree + 1) i on. Lines without an inside; they begin and end in their first and last point.
  /// Error   `sizes`: also another degree, or points that are not degree + 1 for each curve;
  ///         `degenerate`: control points that all lie on one line, exactly. The entry is the curve.
  Status add_beziers(int degree, std::span<const double> x, std::span<const double> y);

  std::size_t size() const;

  struct Data;  ///< the library's own
  const Data& data() const;

 private:
  Data& data();
  Owned<Data> data_;
};

}  // namespace flatray::api
