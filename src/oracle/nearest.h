#pragma once
#include <cstdint>
#include <optional>
#include <span>

#include "geom/hit_interval.h"
#include "geom/ray.h"
#include "oracle/candidates.h"
#include "trace/rays.h"
#include "trace/surfaces.h"

namespace flatray::oracle {

/// The first wall a ray meets at t >= 0, as the tracers must answer.
struct NearestWall {
  /// What decided: bounds of long doubles, or rationals.
  enum class By : std::uint8_t { bounds, rationals };

  std::int64_t wall = -1;  ///< the lowest of those met at the same time; -1 for none
  HitClass kind = HitClass::miss;
  bool at_end = false;
  double t = 0;  ///< the nearest double; infinite beyond the doubles
  By by = By::bounds;
  Root root = Root::none;

  explicit operator bool() const { return wall >= 0; }
};

/// Source  oracle/curves.h for every wall. The quotient of t is the engine's, too (geom/hit_time.h: any
///         exact one is equal to it); verdicts, arithmetic and rounding are not.
/// Cost    some 2 us a wall.
NearestWall nearest_wall(const Ray& ray, std::span<const Segment> walls);

/// The double nearest to the t at which a ray meets one wall, of a curve in the root given; infinite
/// beyond the doubles, nothing where it does not meet it.
///
/// Needs   a direction that is not zero; of arcs that the ray meets them, and not only their curve.
std::optional<double> time_of(const Ray& ray, const Surfaces& walls, std::uint32_t wall, Root root);

/// nearest_wall() for many rays and walls of every kind, which may be curved (oracle/curves.h): walls
/// that bounds rule out are not put to exact arithmetic, which most rays do without.
///
/// Cost    some 10 ns a wall; some 30 us for a curve not ruled out.
class NearestWalls {
 public:
  /// Needs   `walls` to outlive it.
  explicit NearestWalls(const Surfaces& walls);
  NearestWall of(const Ray& ray);

 private:
  const Surfaces& walls_;
  std::vector<Reach> reaches_;  // of each curve
  std::vector<Candidate> straight_, round_;
};

}  // namespace flatray::oracle
