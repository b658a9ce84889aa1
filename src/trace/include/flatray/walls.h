#pragma once
#include <cstdint>
#include <limits>
#include <span>

#include "flatray/owned.h"
#include "flatray/status.h"

namespace flatray::api {

/// The number that stands for no wall: the ray meets none, or has left none.
inline constexpr std::uint32_t kNoWall = 0xffffffffU;
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Walls, numbered from 0 in the order in which they are added. All are closed: their ends belong to
/// them.
///
/// Units   world units. Coordinates may be any finite doubles; none is rounded.
/// Error   `sizes`, `not_finite`, `full`, and what each function names. The entry is the index in
///         the arrays.
/// Owns    copies of all that is added. A copy of it owns copies of its own. Once moved from, it is
///         empty.
/// Threads one alone while walls are added or it is moved; else any number at once.
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
  /// The edges of a polygon of any form: one from each vertex to the next, the last back to the
  /// first. Error   `empty`.
  Status add_ring(std::span<const double> x, std::span<const double> y);
  /// Circles, which rays meet from inside and outside. Radius 0 is a point. Error   `radius`.
  Status add_circles(std::span<const double> x, std::span<const double> y,
                     std::span<const double> radius);
  /// Ellipses: the points (x, y) + a (ux, uy) + b (vx, vy) with a^2 + b^2 = 1, by any two conjugate
  /// half-diameters. Error   `degenerate`: half-diameters that are parallel, exactly.
  Status add_ellipses(std::span<const double> x, std::span<const double> y,
                      std::span<const double> ux, std::span<const double> uy,
                      std::span<const double> vx, std::span<const double> vy);
  /// Arcs of circles. As seen from the centre, an arc runs counter-clockwise from the direction of
  /// the point (from_x, from_y) to the direction of (to_x, to_y). Where such a point is not on the
  /// circle, the arc goes on to it along the line to the centre, so that walls that share the point
  /// leave no gap.
  /// Error   `radius`; `degenerate`: the radius is 0, a point is the centre, or both points lie in
  ///         one direction.
  Status add_arcs(std::span<const double> x, std::span<const double> y,
                  std::span<const double> radius, std::span<const double> from_x,
                  std::span<const double> from_y, std::span<const double> to_x,
                  std::span<const double> to_y);
  /// Bezier curves of degree 2, which are arcs of parabolas, or of degree 3. The control points of
  /// curve i begin at index (degree + 1) i. A curve runs from its first control point to its last,
  /// and has no inside.
  /// Error   `sizes`: also for another degree, and where the points are not degree + 1 a curve;
  ///         `degenerate`: control points that all lie on one line, exactly. The entry is the curve.
  Status add_beziers(int degree, std::span<const double> x, std::span<const double> y);
  /// Arcs of conics: curves of degree 2 whose middle points have weights, below 1 of an ellipse, 1 of a
  /// parabola, above 1 of a hyperbola. The control points of curve i begin at index 3 i.
  /// Error   `sizes`: also where there are not three points a weight; `degenerate`: as of Bezier curves, or a
  ///         weight below 2^-40 or above 2^40. The entry is the curve.
  Status add_conics(std::span<const double> x, std::span<const double> y,
                    std::span<const double> weight);

  std::size_t size() const;

  struct Data;  ///< known to the library alone
  const Data& data() const;

 private:
  Data& data();
  Owned<Data> data_;
};

}  // namespace flatray::api
