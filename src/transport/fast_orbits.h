#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/isa.h"
#include "transport/kernels/flights.h"
#include "transport/orbit_tracer.h"

namespace flatray {

/// What fast orbits cost: flights in all, and those of them that were left to the exact tracer.
struct FlightCounts {
  std::uint64_t flights = 0, exact = 0;
};

/// Orbits for statistics: side by side in the lanes of a kernel, reflected in doubles.
///
/// Each flight is that of the ray its doubles say, but for rounding: its point is put back on the wall
/// and its direction back to length 1. Where rounding could name another wall (near an end of a wall, a
/// tangent, a second wall, or at a grazing angle) the exact tracer is asked for that flight, so
/// nothing leaks. So an orbit is a pseudo-orbit: every step is right to some ulps, nothing is said
/// of the exact orbit of its start, and none is claimed to be near it all along.
class FastOrbits {
 public:
  /// Needs   `exact` and its walls to outlive it; `closed`: a wall lies ahead of every ray, so one that
  ///         finds none is asked exactly.
  FastOrbits(const OrbitTracer& exact, bool closed, Isa isa = active_isa());

  /// Why all flights are left to the exact tracer; "" where lanes follow them.
  const std::string& obstacle() const { return obstacle_; }

  /// As OrbitTracer::follow, with directions brought to length 1: `t` is in world units.
  ///
  /// Gives   the same bits in every tier, whatever other orbits are followed.
  /// Error   a step within some 2^-50 of the room, over the cosine of the incidence; path lengths by the
  ///         rounding of their sum.
  /// Cost    a flight 5 to 10 ns in a room of few walls, and about 1.5 ns more for each wall.
  FlightCounts follow(std::span<const OrbitStart> starts, std::uint64_t bounces,
                      OrbitSink& sink) const;

 private:
  class Wave;

  std::string look_for_obstacle() const;
  void add(std::uint32_t surface, double (&record)[flights::kRecord]);
  void add_segments(bool hull);
  void add_curves(bool circles);
  void join_periodic();
  bool is_at_wall(const Vec2& point) const;
  double reach(const Vec2& out) const;

  const OrbitTracer& exact_;
  bool closed_;
  std::string obstacle_;
  std::vector<double> records_;          // by slot
  std::vector<std::uint32_t> surfaces_;  // by slot
  std::vector<double> slots_;            // by surface
  std::vector<CellIndex> steps_;         // by slot: to the cell beyond a periodic wall
  flights::Walls walls_{};
  flights::Fly fly_;
};

}  // namespace flatray
