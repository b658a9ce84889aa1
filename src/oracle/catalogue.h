#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "geom/hit_interval.h"
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
  /// How it ends: all bounces made, out in the open, in a corner, along the wall it starts on; in
  /// any way but out in the open; in any way.
  enum class End : std::uint8_t { limit, escape, corner, along, any, open } end = End::limit;
  std::optional<std::uint64_t> count{};  ///< bounces it has, where that is known in closed form
  /// The first bounces whose walls long_orbit() tells.
  std::uint64_t ordered = 0;
  /// The first walls that are a convex room, counter-clockwise, which no bounce may lie outside; of
  /// circles none may lie on another side than its start.
  std::size_t room = 0;
  /// Whether the way back from the last bounce has to lead over the same walls.
  bool there_and_back = false;
};

/// Two convex polygons of a stiff case in linear motion, and when they meet, as the catalogue has it.
struct StiffContact {
  std::vector<Vec2> a;
  Vec2 velocity_a;
  std::vector<Vec2> b;
  Vec2 velocity_b;
  HitClass kind = HitClass::miss;
  double first = 0, last = 0;  ///< the nearest doubles; of a miss nothing
  Range within = kRay;
};

/// A case of the catalogue of stiff and extreme inputs.
struct StiffCase {
  const char* id;     ///< "A7"
  const char* words;  ///< what is hard about it
  const char*
      held_by;  ///< the test of it: "trace.StiffWalls.A7ToA11NearParallel", "cli.e8_crash_safety"
  std::vector<StiffRay> rays{};
  std::vector<StiffOrbits> orbits{};
  std::vector<StiffContact> contacts{};
  const char* matter = "";  ///< where it has none of these, what it is about instead: "a file"

  /// Whether it asks anything of what finds walls.
  bool concerns_tracers() const { return !rays.empty() || !orbits.empty(); }
};

/// All of the catalogue, A1 to F5; those about files and pictures name their test alone.
std::vector<StiffCase> catalogue();

/// Its parts by letter: A, B and F, of Bezier curves, are rays, C orbits, D contacts.
std::vector<StiffCase> stiff_rays();
std::vector<StiffCase> stiff_orbits();
std::vector<StiffCase> stiff_contacts();
/// More orbits of C: rooms where the catalogue's figure is a statistic, and starts that are bad.
std::vector<StiffCase> stiff_rooms();

}  // namespace flatray::oracle
