#pragma once
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "geom/primitives/arc.h"
#include "geom/primitives/bezier.h"
#include "geom/ray.h"

namespace flatray::oracle {

/// A wall that may be the first a ray meets, and when it meets it.
struct Candidate {
  std::int64_t wall = -1;
  bool sure = false;  ///< met ahead, between its ends and away from them, at a time in between
  long double low = 0, high = std::numeric_limits<long double>::infinity();
};

/// Fills `candidates` with the walls that may be first, in order of their numbers.
///
/// Needs   finite doubles. Long doubles of 64 bits and their wide range of exponents: products of
///         differences of doubles neither overflow nor underflow there, so that every result is off
///         by a known part of itself (what valgrind computes in their place does not do).
/// Gives   every wall met first, and few others: all if the direction is zero.
/// Cost    some 10 ns a wall.
void find_candidates(const Ray& ray, std::span<const Segment> walls,
                     std::vector<Candidate>& candidates);

/// A disc that holds a curved wall.
struct Reach {
  Vec2 centre;
  long double radius = 0;
  bool is_border = false;  ///< the wall is the whole border of the disc
};
Reach reach_of(const Arc& arc);
Reach reach_of(const Bezier& curve);
Reach reach_of(const Segment& wall);

/// The same for curved walls, each by its disc: those that may be met at `first` or before.
void find_candidates(const Ray& ray, std::span<const Reach> curves, long double first,
                     std::vector<Candidate>& candidates);

}  // namespace flatray::oracle
