#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "flatray/trace.h"

/// Orbits: rays followed from mirror to mirror. Every decision is exact for the doubles that the
/// ray has at that bounce, and is the same on every machine.
namespace flatray::api {

/// One reflection.
struct Bounce {
  std::uint32_t wall;
  /// On the side of the wall from which the ray came: the double nearest to the exact point, or one
  /// at most 2 ulp from that in each coordinate.
  double x, y;
  double t;  ///< from the bounce before to this one, in lengths of the direction between them
  /// From the start, world units; infinite where lengths, or sums of t, are beyond the doubles.
  double path_length;
  double normal_x, normal_y;        ///< unit, towards the side the ray came from
  double direction_x, direction_y;  ///< after the bounce, as long as that of the start

  bool operator==(const Bounce&) const = default;
};

/// Why an orbit ended.
enum class OrbitEnd : std::uint8_t {
  limit,     ///< all bounces asked for were made
  escape,    ///< nothing lies ahead
  absorbed,  ///< arrived at a wall that absorbs
  corner,  ///< arrived at an end of a wall, or where two meet, or no double lies beside it: no reflection
  along  ///< runs along a wall, or so nearly that no double leads away from it
};

/// One orbit: its bounces are [begin, end) of the bounces of all orbits.
struct Orbit {
  std::size_t begin = 0, end = 0;
  OrbitEnd reason = OrbitEnd::escape;
  double x = 0, y = 0;          ///< where it was absorbed or met the corner, else last bounced
  double out_x = 0, out_y = 0;  ///< unit direction after the last bounce

  bool operator==(const Orbit&) const = default;
};

/// What becomes of a ray that arrives exactly at an end of a wall, or where two meet.
enum class CornerRule : std::uint8_t {
  stop,  ///< the orbit ends there
  back   ///< it returns the way it came: a bounce off the wall of the lowest number there
};

/// Walls made ready for orbits. All are mirrors on both sides, but for those that absorb() names.
///
/// Owns    its walls. Once it is moved from, it has none: every ray escapes.
/// Threads any number may ask one room at once, but not while absorb() runs. A call starts no
///         thread.
class Room {
 public:
  /// Takes the walls: move them in, or pass a copy. Cost    linear in them.
  explicit Room(Walls walls, CornerRule corners = CornerRule::stop);
  Room(Room&&) noexcept;
  Room& operator=(Room&&) noexcept;
  ~Room();

  std::size_t walls() const;
  /// From now on these walls end the orbits that arrive there. Error   `no_such`.
  Status absorb(std::span<const std::uint32_t> walls);

  /// Follows each ray for at most `bounces` bounces; with 0 only the start is looked at.
  ///
  /// Needs   directions that are not zero. Rays::departed and Rays::tangents play no part: a ray that
  ///         starts on a wall counts as having just left it, and a ray passes by a curve that it
  ///         touches in one point.
  /// Gives   one orbit a ray, in order, and the bounces, those of one orbit in a row. What a ray
  ///         does depends on no other ray.
  /// Error   `sizes`, `not_finite`, `direction`: the entry is the ray.
  /// Cost    0.3 to 1.2 us and 80 bytes a bounce; three times as many while it runs.
  Status orbits(const Rays& starts, std::uint64_t bounces, std::vector<Orbit>& orbits,
                std::vector<Bounce>& all_bounces) const;

 private:
  struct Data;
  Owned<Data> data_;
};

}  // namespace flatray::api
