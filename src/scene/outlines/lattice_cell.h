#pragma once
#include <optional>
#include <string>

#include "scene/scene.h"

namespace flatray {

/// The two vectors of a lattice, each from one corner of its cell to another: as exact numbers.
struct Lattice {
  Segment a, b;

  /// A place n times the one and m times the other on, rounded once.
  Vec2 moved(const Vec2& place, int n, int m) const;
};

/// Why the walls of a shape cannot be those of a cell that fills the plane by translations.
struct CellFault {
  std::string message, hint;
};
/// Nothing where it is one convex polygon of four or six corners that lie opposite each other about
/// one point, exactly for the doubles: then each edge is that opposite, moved by exact numbers.
std::optional<CellFault> cell_fault(const Shape& shape);

/// How far apart the two opposite edges are that are closest together.
/// Needs   a shape without a fault.
double cell_depth(const Shape& cell);

/// Adds to the pillars of a chamber with periodic walls the copies of its discs that stand across
/// these, from every cell out of which one reaches into this: up to two away, which is all where the radius
/// is at most the cell's depth.
///
/// Needs   a shape without a fault. Discs that are off the middle of their shape and turned are not
///         looked at.
/// Error   centres of copies are rounded once: exact in the corners of the cell.
void add_copies_of_discs(Scene& scene, Chamber& chamber);

}  // namespace flatray
