#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "flatray/walls.h"

/// Which wall each of many rays meets, and where rays run inside convex shapes. Every answer is
/// decided exactly for the doubles given, and is the same on every machine.
namespace flatray::api {

/// Where the line of a ray meets a circle, an ellipse or an arc: it enters by the first root and
/// leaves by the second. Of a Bezier curve it crosses from the left by the first and third and from
/// the right by the second and fourth, in their order along the curve.
enum class Root : std::uint8_t { none, first, second, both, third, fourth };

/// What a ray has just left and does not meet again: a segment by its number, a curve by its number
/// and in the root stood on; `both` leaves the whole curve out. No distance is involved. Of a Bezier
/// curve every root but `none` leaves out what is met at t = 0, and nothing else.
struct DepartedSurface {
  std::uint32_t wall = kNoWall;
  Root root = Root::none;
};

/// Rays, one entry each: origin (ox, oy) + t * direction (dx, dy) for t >= 0. A direction of any
/// length; zero asks what the origin lies on.
///
/// Owns    nothing: the arrays must live until the call they are given to returns.
struct Rays {
  std::span<const double> ox, oy, dx, dy;
  std::span<const DepartedSurface> departed{};  ///< none, or one a ray
  bool tangents = true;                         ///< whether a curve touched in one point is met

  std::size_t size() const { return ox.size(); }
};

/// How a ray meets a wall or a closed shape.
enum class HitClass : std::uint8_t {
  none,
  touch,   ///< in one point
  along,   ///< in a stretch, all of it on the boundary
  through  ///< in the interior; of a curve as a wall: crosses it
};

/// A wall that a ray meets.
struct Hit {
  double t = kInfinity;  ///< in lengths of the direction, to 1 ulp; the largest double if beyond it
  std::uint32_t wall = kNoWall;
  HitClass kind = HitClass::none;
  Root root = Root::none;  ///< of a curve; `both` where the ray is tangent to it
  bool at_end = false;     ///< exactly at an end of the wall

  bool operator==(const Hit&) const = default;
};

/// Walls made ready for any number of rays.
///
/// Error   `sizes`, `not_finite`; `no_such`: the number of a wall in Rays::left. The entry is the ray.
///         Of a tracer moved from every ray meets nothing.
/// Owns    its walls.
/// Threads any number may ask one tracer at once. A call starts none of its own.
class RayTracer {
 public:
  /// Takes the walls: move them in, or pass a copy.
  /// Cost    linear in them, on so many threads; what is built does not depend on how many.
  explicit RayTracer(Walls walls, unsigned threads = 1);
  RayTracer(RayTracer&&) noexcept;
  RayTracer& operator=(RayTracer&&) noexcept;
  ~RayTracer();

  std::size_t walls() const;

  /// The first wall of each ray; of several at the same t that of the lowest number.
  ///
  /// Needs   as many hits as rays.
  /// Cost    among 16 to 65 536 segments 25 to 50 ns a ray in calls of thousands, 150 to 250 ns in a
  ///         call of its own; among circles some 400 ns.
  Status nearest(const Rays& rays, std::span<Hit> hits) const;
  /// Whether each ray meets a wall at `up_to` or before, which may be infinite: 1 or 0.
  ///
  /// Needs   as many of both as rays.
  /// Gives   the exact answer, also where t rounds to `up_to`.
  Status any(const Rays& rays, std::span<const double> up_to, std::span<std::uint8_t> met) const;
  /// Every wall each ray meets, in order of t, and of those met together by number: those of ray i
  /// are hits[ends[i - 1]] to hits[ends[i]], of ray 0 from hits[0] on.
  ///
  /// Gives   a segment that the ray runs along once, a curve that it crosses twice.
  /// Cost    a ray crosses all cells on its way, and 1 us a hit: 6 us among 4096 segments, 50 us among
  ///         65 536.
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

/// Where an origin lies, or how two bodies are at t = 0.
enum class StartPlace : std::uint8_t {
  outside,   ///< two bodies: apart
  boundary,  ///< they touch
  inside     ///< they overlap
};

inline constexpr std::int32_t kNoEdge = -1;

/// The part of a ray inside a closed convex shape.
struct Interval {
  double enter = 1, exit = 0;  ///< to 1 ulp; enter > exit exactly where `kind` is none
  /// Edge i runs from vertex i to the next; kNoEdge where the interval ends with the range, or of a
  /// disc. Of two edges at a vertex the lower number.
  std::int32_t edge_enter = kNoEdge, edge_exit = kNoEdge;
  HitClass kind = HitClass::none;
  StartPlace start = StartPlace::outside;
  bool enter_overflows = false,
       exit_overflows = false;  ///< that t lies beyond the doubles, given as the largest

  bool operator==(const Interval&) const = default;
};

/// The part of each ray inside one convex polygon, by Cyrus-Beck clipping.
///
/// Needs   vertices in either orientation, which may repeat or lie on one line; as many intervals as
///         rays. Rays::left and Rays::tangents play no part.
/// Error   `sizes`, `not_finite`, `empty`, `not_convex`: the entry is the ray or the vertex.
/// Cost    some 70 ns a ray that meets it and less of one that does not, under 1 ns an edge; of many
///         edges the logarithm of their number.
/// Threads any number.
Status clip_convex(const Rays& rays, std::span<const double> x, std::span<const double> y,
                   Range within, std::span<Interval> intervals);
/// The same inside a disc. Radius 0 is a point. Error   `sizes`, `not_finite`, `radius`.
Status clip_disc(const Rays& rays, double x, double y, double radius, Range within,
                 std::span<Interval> intervals);

}  // namespace flatray::api
