#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "trace/surfaces.h"

namespace flatray::oracle {

/// A ray of a stiff case among walls, and the first t at which it meets one, as the catalogue has it.
struct StiffRay {
  std::shared_ptr<const Surfaces> walls;
  Ray ray;
  std::optional<double> t;  ///< nothing is met
};

/// Orbits of a stiff case between mirrors.
struct StiffOrbits {
  Surfaces walls;
  std::vector<Ray> starts;
  std::uint64_t bounces = 0;  ///< to follow, at most
  /// How it ends: all bounces made, out in the open, or in a corner.
  enum class End : std::uint8_t { limit, escape, corner, any } end = End::limit;
  std::optional<std::uint64_t> count{};  ///< bounces it has, where that is known in closed form
  /// The first bounces whose walls long_orbit() tells.
  std::uint64_t ordered = 0;
  /// The first walls that are a convex room, counter-clockwise, which no bounce may lie outside; of
  /// circles none may lie on another side than its start.
  std::size_t room = 0;
};

/// A case of the catalogue of stiff and extreme inputs.
struct StiffCase {
  const char* id;     ///< "A7"
  const char* words;  ///< what is hard about it
  const char*
      held_by;  ///< the test of it: "trace.StiffWalls.A7ToA11NearParallel", "cli.e8_crash_safety"
  std::vector<StiffRay> rays{};
  std::vector<StiffOrbits> orbits{};

  /// Whether it asks anything of what finds walls.
  bool concerns_tracers() const { return !rays.empty() || !orbits.empty(); }
};

/// All of the catalogue, A1 to E11; those that tracers have no part in name their test alone.
std::vector<StiffCase> catalogue();

/// Its parts by letter: A and B are rays, C orbits.
std::vector<StiffCase> stiff_rays();
std::vector<StiffCase> stiff_orbits();

}  // namespace flatray::oracle
