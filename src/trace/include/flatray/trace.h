#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "flatray/walls.h"

/// Which wall each of many rays meets, and where rays run inside convex shapes. Every answer is
/// decided exactly for the doubles given, and is the same on every machine.
namespace flatray::api {

/// Which of the points in which the line of a ray meets a curve. It enters a circle, an ellipse or
/// an arc by the first root and leaves it by the second; a tangent has `both` in one. It crosses a
/// Bezier curve from the left by the first and third root and from the right by the second and
/// fourth, each two in their order along the curve.
enum class Root : std::uint8_t { none, first, second, both, third, fourth };

/// The wall that a ray has just left, and so does not meet again. A segment is left out as a whole.
/// Of a circle, an ellipse or an arc the root in which the ray stands on it is left out, and with
/// `both` the whole curve. Of a Bezier curve every root but `none` leaves out what is met at t = 0,
/// and nothing else. No distance is involved.
struct DepartedSurface {
  std::uint32_t wall = kNoWall;
  Root root = Root::none;
};

/// Rays, one entry each: origin (ox, oy) + t * direction (dx, dy) for t >= 0. The direction may
/// have any length; a ray whose direction is zero asks what its origin lies on.
///
/// Owns    nothing: the arrays must live until the call that takes them returns.
struct Rays {
  std::span<const double> ox, oy, dx, dy;
  std::span<const DepartedSurface> departed{};  ///< empty, or one entry a ray
  bool tangents = true;                         ///< whether a curve touched between its ends is met

  std::size_t size() const { return ox.size(); }
};

/// How a ray meets a wall or a closed shape: the class of a hit.
enum class HitClass : std::uint8_t {
  none,
  touch,   ///< in one point; a segment that it crosses, too
  along,   ///< in a stretch, all of it on the boundary
  through  ///< in the interior; a curve that is a wall: crosses it
};

/// A wall that a ray meets.
struct Hit {
  /// In lengths of the direction, the nearest double; the largest one where it lies beyond the
  /// doubles.
  double t = kInfinity;
  std::uint32_t wall = kNoWall;
  HitClass kind = HitClass::none;
  Root root = Root::none;  ///< of a curve; `both` where the ray is tangent to it
  bool at_end = false;     ///< exactly at an end of the wall

  bool operator==(const Hit&) const = default;
};

/// Walls made ready for any number of rays.
///
/// Error   `sizes`, `not_finite`; `no_such`: Rays::departed has the number of no wall. The entry is
///         the ray.
/// Owns    its walls. Once it is moved from, it has none: no ray meets anything.
/// Threads any number may ask one tracer at once. A call starts no thread.
class RayTracer {
 public:
  /// Takes the walls: move them in, or pass a copy.
  /// Cost    linear in them, on `threads` threads; what is built does not depend on their number.
  explicit RayTracer(Walls walls, unsigned threads = 1);
  RayTracer(RayTracer&&) noexcept;
  RayTracer& operator=(RayTracer&&) noexcept;
  ~RayTracer();

  std::size_t walls() const;

  /// The first wall of each ray; of several at the same t the one of the lowest number.
  ///
  /// Needs   as many hits as rays.
  /// Cost    among 16 to 65 536 segments 25 to 50 ns a ray in calls of thousands, 150 to 250 ns in a
  ///         call of its own; among circles some 400 ns.
  Status nearest(const Rays& rays, std::span<Hit> hits) const;
  /// Whether each ray meets a wall at t <= `up_to`: 1 or 0. `up_to` may be infinite.
  ///
  /// Needs   as many of both as rays.
  /// Gives   the exact answer, also where t rounds to `up_to`.
  Status any(const Rays& rays, std::span<const double> up_to, std::span<std::uint8_t> met) const;
  /// Every wall that each ray meets, in order of t; those at the same t by number. The hits of ray
  /// i are [ends[i - 1], ends[i]) of `hits`; those of ray 0 begin at 0.
  ///
  /// Gives   a segment along which the ray runs once; a curve once for each point in which it is
  ///         met.
  /// Cost    the cells on the whole way of a ray, and 1 us a hit: 6 us among 4096 segments, 50 us
  ///         among 65 536.
  Status all(const Rays& rays, std::vector<Hit>& hits, std::vector<std::size_t>& ends) const;

 private:
  struct Data;
  Owned<Data> data_;
};

/// Closed range of t that an answer is clipped to; its ends may be infinite.
struct Range {
  double low, high;
};
inline constexpr Range kLine{-kInfinity, kInfinity}, kRay{0, kInfinity}, kSegment{0, 1};

/// Where the origin of a ray lies in a shape, or how two bodies lie at t = 0.
enum class StartPlace : std::uint8_t {
  outside,   ///< two bodies: apart
  boundary,  ///< they touch
  inside     ///< they overlap
};

inline constexpr std::int32_t kNoEdge = -1;

/// The part of a ray inside a closed convex shape.
struct Interval {
  double enter = 1, exit = 0;  ///< nearest doubles; enter > exit exactly where `kind` is none
  /// The edges by which the ray enters and leaves; edge i runs from vertex i to the next. Of two
  /// edges that meet there it is the lower number; at a vertex that is only touched it enters by one and
  /// leaves by the other. kNoEdge where the interval ends with the
  /// range, and of a disc.
  std::int32_t edge_enter = kNoEdge, edge_exit = kNoEdge;
  HitClass kind = HitClass::none;
  StartPlace start = StartPlace::outside;
  bool enter_overflows = false,
       exit_overflows = false;  ///< that t lies beyond the doubles and is given as the largest

  bool operator==(const Interval&) const = default;
};

/// The part of each ray inside one convex polygon, by Cyrus-Beck clipping.
///
/// Needs   vertices in either orientation, which may repeat or lie on one line; as many intervals as
///         rays. Rays::departed and Rays::tangents play no part.
/// Error   `sizes`, `not_finite`, `empty`, `not_convex`: the entry is the ray or the vertex.
/// Cost    some 70 ns for a ray that meets the polygon, less for one that does not, and under 1 ns
///         an edge; for many edges the logarithm of their number.
/// Threads any number may call it at once.
Status clip_convex(const Rays& rays, std::span<const double> x, std::span<const double> y,
                   Range within, std::span<Interval> intervals);
/// The same inside a disc. Radius 0 is a point. Error   `sizes`, `not_finite`, `radius`.
Status clip_disc(const Rays& rays, double x, double y, double radius, Range within,
                 std::span<Interval> intervals);

}  // namespace flatray::api
