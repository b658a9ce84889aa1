#pragma once

// What the kernels of the contact of many pairs take and give: plain data only, so that nothing
// compiled for one instruction-set tier can be picked by the linker for another.
//
// They work in floats, as seen from the centre of each shape. A pair they call apart is proven to
// be; of all others they guess the edges, which are then proven by exact predicates. So every tier
// gives the same answers.
namespace flatray::sweep {

inline constexpr int kCorners = 8;  ///< at most, of a shape in the lanes

/// A convex polygon, counter-clockwise as seen from its centre; what is left over repeats the first.
struct Shape {
  float normal_x[kCorners], normal_y[kCorners];  ///< unit, outward, about
  float reach[kCorners];                         ///< about the largest normal . vertex
  float x[kCorners], y[kCorners];
};

/// Two shapes of which the second moves past the first.
struct Pair {
  const Shape *a, *b;
  float centre_x, centre_y;    ///< of b, seen from that of a
  float way_x, way_y;          ///< of b in a unit of time, seen from a
  float gap_error, way_error;  ///< more than rounding can add to a gap, and to how it changes
};

/// What a kernel tells of a pair.
struct Guess {
  /// When it begins to meet, and when it ends with the opposite sign, about; the last seven bits are
  /// the edge that decides it, from kCorners on one of b, and the corner of the other shape that
  /// meets it, times kCornerUnit. `enter` is kApart where an edge keeps the
  /// shapes apart all the time.
  float enter, leave;
  /// Negative where the shapes surely overlap at the start and at the end.
  float first_gap, last_gap;
};
/// Sizes, distances and speeds above could overflow in floats.
inline constexpr double kLargest = 0x1p60;
inline constexpr float kApart = 0x1p127F;
inline constexpr unsigned kEdgeBits = 15, kCornerUnit = 16, kGuessBits = 127;

/// Shapes as they move for t in [0, length].
using Kernel = void (*)(const Pair* pairs, int count, float length, Guess* guesses);

}  // namespace flatray::sweep
