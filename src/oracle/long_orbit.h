#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "scene/scene.h"
#include "trace/surfaces.h"

namespace flatray::oracle {

/// An orbit among walls in a fixed number of bits, to check certified ones by.
struct LongOrbit {
  struct Bounce {
    std::uint32_t surface;
    Vec2 point;           ///< nearest doubles
    Vec2 beyond;          ///< how far from there it is, to as many digits as a double has
    bool corner = false;  ///< at an end of the wall, or where another is met as well
  };
  enum class End { limit, escape, absorbed };
  std::vector<Bounce>
      bounces;  ///< fewer than asked for where it ends; of a wall that absorbs, or a hole, the last
  End end = End::limit;
};

/// Follows a ray as a moving point: it meets walls by Cramer's rule and the quadratic formula, and
/// is turned by v - 2 (v.n) n / n.n. Nothing is bounded: errors of 2^-bits grow as orbits part, so
/// that `bits` must leave room, and the same walls and points at two numbers of bits say that it did.
///
/// Needs   a start in no corner; no flight below 2^(-bits/4) of the walls. Materials by surface, or
///         none: all mirrors. Periodic walls are the edges of one cell in order, straight ones.
/// Gives   of walls met together, to bits/2, the lowest number, marked as a corner; from there on the
///         orbit is one of several. What touches a curve, to as many bits, passes it. An escape after
///         2^18 periodic walls without a bounce, or where they lead back to where the first led.
/// Source  GMP's mpf.
LongOrbit long_orbit(const Surfaces& walls, const Ray& start, std::uint64_t bounces, unsigned bits,
                     std::span<const Material> materials = {});

}  // namespace flatray::oracle
