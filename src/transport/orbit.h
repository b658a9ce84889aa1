#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "scene/scene.h"
#include "trace/surfaces.h"
#include "trace/tracer.h"
#include "transport/periodic_walls.h"

namespace flatray {

class Glass;

enum class OrbitEnd {
  limit,     ///< all bounces asked for were made
  escape,    ///< nothing lies ahead; between periodic walls, not in 2^18 crossings
  absorbed,  ///< arrived at a surface that absorbs, or at a hole
  corner,    ///< arrived at an end of a wall, or where two meet: no reflection is defined
  along,     ///< starts on a straight wall and runs along it
  cyclotron  ///< in a field: it circles freely, meeting no wall
};
const char* name(OrbitEnd end);

/// What becomes of a ray that arrives exactly at an end of a wall, or where two meet.
enum class CornerRule {
  stop,  ///< the orbit ends there
  back   ///< it returns the way it came, which is the limit from both sides where walls meet at
         ///< pi / m, m even; listed as a bounce off the lowest wall of the corner
};

/// Who takes a ray that arrives at all of some walls at once: a hole alone, whose ends belong to it, else
/// all of them where all absorb; none where it is reflected or meets a corner.
std::vector<std::uint32_t> taken_by(std::span<const Material> materials,
                                    std::span<const std::uint32_t> walls);

/// One reflection, or refraction by glass.
struct Bounce {
  std::uint32_t surface;
  Vec2 point;  ///< on the closed inner side of its wall and of every wall that meets it there
  double t;    ///< since the last bounce, in lengths of the direction then
  double path_length;  ///< from the start, world units
  Vec2 normal;         ///< unit, towards the side the ray came from
  Vec2 in, out;        ///< directions before and after it, as long as that of the start
  CellIndex cell{};    ///< between periodic walls: the copy of the cell in which it is, by which
                       ///< lattice vectors the point is away from where it would be in the plane

  /// Radians between the ray and the normal, [0, pi/2].
  double incidence() const;
  /// Whether it went on through glass: an orbit whose direction after it does not tell ends before.
  bool is_refracted() const { return out.dot(normal) < 0; }
};

/// A periodic wall crossed.
struct Crossing {
  std::size_t bounces;  ///< that were before it
  Vec2 from, to;        ///< on the wall left by, on that opposite
  CellIndex step;       ///< from the cell left to that entered
};

/// How an orbit came to an end.
struct OrbitStop {
  OrbitEnd end = OrbitEnd::limit;
  Vec2 out{0, 0};        ///< unit direction after the last bounce
  Vec2 end_point{0, 0};  ///< where it was absorbed or met the corner, or last bounced
  std::vector<std::uint32_t>
      end_surfaces{};  ///< the absorbing surface or hole; the walls of the corner
};

struct Orbit : OrbitStop {
  Vec2 start{0, 0}, direction{0, 0};
  std::vector<Bounce> bounces{};
  std::vector<Crossing> crossings{};  ///< in order
  double field = 0;                   ///< as OrbitRules has it
};

/// One straight part of an orbit; many in turn of what flies an arc of a circle.
struct OrbitLine {
  Segment line;
  bool reflected;  ///< at its end; else it crosses a periodic wall there, or ends
};
/// The way of an orbit; where it escapes, the last line is of length 1.
std::vector<OrbitLine> orbit_lines(const Orbit& orbit);

/// Whether it goes on into the open after its last bounce, and not from periodic wall to wall.
inline bool leaves(const Orbit& orbit) {
  return orbit.end == OrbitEnd::escape && orbit.crossings.empty();
}

/// What an orbit does where its walls leave a choice.
struct OrbitRules {
  CornerRule corners = CornerRule::stop;
  /// What finds the walls; nullptr: the one of choice. Of one that is not exact the walls are its
  /// own; one it only believes to be crossed ends the orbit there, as a corner.
  const Tracer* tracer = nullptr;
  /// A magnetic field across the room: the curvature of flights, one over their radius, positive to the
  /// left; 0: they are straight. With it corners stop.
  double field = 0;
  /// What orbits go through, by chance; nullptr: none. With it corners stop; in a field, and between
  /// periodic walls, there is none.
  const Glass* glass = nullptr;
};

/// Follows a ray from mirror to mirror: each decision is exact, each point and direction is rounded
/// to doubles. A straight wall just left is excluded by its number, a curve only in the root in
/// which the ray stands on it. No epsilon.
///
/// Needs   `materials` by surface, periodic those of one cell at most (PeriodicWalls); a direction that is
///         not zero; in a field walls that are straight or of circles, none of them periodic.
/// Gives   a start on a wall counts as having just left it; a start where walls meet, or at an end
///         of one, is a corner without a bounce; a start along a straight wall ends as `along`. A
///         circle reflects on both sides; touched in one point it is passed by, and on its outer side
///         left from a start on it along its tangent, that of a chamber too. A corner whose walls all absorb absorbs,
///         and so does one at the end of a hole. With 0 bounces only the start is looked at. Periodic walls are
///         crossed, in a corner of theirs two at a time; with them every other corner stops. In a field a wall
///         touched in one point is passed by, too, and one left is met again where the flight comes round to it.
/// Error   each wall is right for the doubles the ray then has; points within 1 ulp, put back on
///         the inner side by at most 2 more; the length of the direction within 4 ulp of the
///         start's, after any number of bounces.
/// Cost    a bounce 0.3 to 1.2 us; the walls are sorted into cells once, O(n). In a field all walls are
///         looked at, some 0.2 us each.
Orbit trace_orbit(const Surfaces& walls, std::span<const Material> materials, const Ray& start,
                  std::uint64_t bounces, const OrbitRules& rules = {});

/// The orbits of many rays, advanced together so that the tracer gets them in batches. Each is what
/// trace_orbit gives.
std::vector<Orbit> trace_orbits(const Surfaces& walls, std::span<const Material> materials,
                                std::span<const Ray> starts, std::uint64_t bounces,
                                const OrbitRules& rules = {});

}  // namespace flatray
