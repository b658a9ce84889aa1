#pragma once
#include <span>
#include <string>
#include <vector>

#include "anim/solids.h"
#include "base/table.h"
#include "transport/glass.h"
#include "transport/moving_orbit.h"

namespace flatray {

/// The walls orbits of a frame are followed among, and what stands behind them.
struct OrbitRoom {
  const Scene& scene;
  World world;
  std::vector<Material> materials = world.materials();
  Glass glass{scene, world};
  Solids solids;
  Bounds window;  ///< of the scene's film

  OrbitRoom(const Scene& of, const FrameState& state);
};

/// How an orbit is followed.
struct OrbitRequest {
  bool certified = false;
  unsigned most_bits = 0;  ///< of a certified one
  OrbitRules rules{};
  std::uint64_t chance = 0;  ///< as OrbitStart has it
};

/// One ray of a scene and what became of it.
struct OrbitReport {
  std::string ray;
  /// Whose walls the orbit names: that of the room, or of walls as they move, of which none is left
  /// out. It outlives the report.
  const World* world;
  Orbit orbit;
  std::string start;  ///< "free", "on hall edge 2", "inside hall/post", "outside hall"
  bool starts_badly;  ///< in an obstacle, or outside the chamber
  std::uint64_t certain =
      0;                    ///< bounces from the first on that are proven to be those of the exact
                            ///< orbit; doubles are looked at for the first 10 000
  bool end_certain = true;  ///< all bounces are, and it ends as the exact orbit does
  bool unproven = false;    ///< by nature: at finite speed, in a field, split by glass
  bool certified = false;   ///< not in doubles
  unsigned bits = 0;        ///< that a certified orbit took; 0 for doubles, and for none needed
  bool rational = false;    ///< that it took numbers without error of so many bits
  std::uint64_t horizon = 0;  ///< of a certified orbit: bounces until doubles are noise, or all
  bool decided = true;        ///< false: the bits allowed were not enough for what comes next
  /// At finite speed, of which nothing is proven: when it set off, when each bounce was, and when
  /// it ended.
  struct Clock {
    double start, end;
    std::vector<BounceTime> bounces;
  };
  std::optional<Clock> clock{};
};

/// Error   of certified orbits: Trouble::unavailable without their module.
Result<OrbitReport> follow_orbit(const OrbitRoom& room, const std::string& name, const Ray& start,
                                 std::uint64_t bounces, const OrbitRequest& request);

/// The same at finite speed, of a particle that sets off at time `from`.
/// Needs   walls of the room as they move, which outlive the report, a velocity for a direction.
OrbitReport follow_moving(const OrbitRoom& room, const MovingWalls& walls, const std::string& name,
                          const Ray& start, double from, const MovingLimits& limits);

/// As `flatray orbit` prints it: rows, made from room and reports when they are written, an object,
/// and for people. The time and the speed after each bounce are told where any report has them, and
/// empty where walls stand still.
Table bounce_table(const OrbitRoom& room, std::span<const OrbitReport> reports);
JsonValue as_value(const OrbitRoom& room, const OrbitReport& report);
std::string status_line(const OrbitRoom& room, const OrbitReport& report);

/// Walls, paths, bounces by number where they are few and there is room, in the scene's window; a
/// ray that leaves ends at the border.
std::string svg_of(const OrbitRoom& room, const std::vector<OrbitReport>& reports);

}  // namespace flatray
