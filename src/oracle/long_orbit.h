#pragma once
#include <vector>

#include "trace/surfaces.h"

namespace flatray::oracle {

/// An orbit among mirrors in a fixed number of bits, to check certified ones by.
struct LongOrbit {
  struct Bounce {
    std::uint32_t surface;
    Vec2 point;  ///< nearest doubles
  };
  std::vector<Bounce> bounces;  ///< fewer than asked for where nothing lies ahead
};

/// Follows a ray as a moving point: it meets walls by Cramer's rule and the quadratic formula, and
/// is turned by v - 2 (v.n) n / n.n. Nothing is bounded: errors of 2^-bits grow as orbits part, so
/// that `bits` must leave room, and the same walls and points at two numbers of bits say that it did.
///
/// Needs   a start in no corner, an orbit that meets none; no flight below 2^(-bits/4) of the walls;
///         ends of arcs on their curves.
/// Gives   of walls met together, to bits/2, the lowest number.
/// Source  GMP's mpf.
LongOrbit long_orbit(const Surfaces& walls, const Ray& start, std::uint64_t bounces, unsigned bits);

}  // namespace flatray::oracle
