#pragma once

// What the kernels of the contact of many pairs take and give: plain data only, so that nothing
// compiled for one instruction-set tier can be picked by the linker for another. Whatever they cull or
// certify is proven, so that every tier gives the same answers.
namespace flatray::pairs {

/// Bodies that move, as they lie in memory: of the first pair its two bodies, as numbers, and both
/// velocities, x and y; each next one is `stride` bytes on.
struct Moves {
  const unsigned* bodies;
  const double* velocities;
  long stride;
};

inline constexpr int kCorners = 8;  ///< at most, of an outline

/// A convex polygon, counter-clockwise as seen from its centre; what is left over repeats the first.
struct Outline {
  float normal_x[kCorners], normal_y[kCorners];  ///< unit, outward, about
  float reach[kCorners];                         ///< about the largest normal . vertex
  float x[kCorners], y[kCorners];
};

/// Two outlines of which the second moves past the first.
struct Approach {
  const Outline *a, *b;
  float centre_x, centre_y;    ///< of b, seen from that of a
  float way_x, way_y;          ///< of b in a unit of time, seen from a
  float gap_error, way_error;  ///< more than rounding can add to a gap, and to how it changes
};
/// Sizes, distances and speeds above could overflow in floats.
inline constexpr double kLargest = 0x1p60;

/// The edges by which two outlines begin and end to meet, about.
struct Candidates {
  /// When they begin to meet, and when they end with the opposite sign, about; the last seven bits are
  /// the edge that decides it, from kCorners on one of b, and the corner of the other outline that
  /// meets it, times kCornerUnit. `enter` is kApart where an edge keeps them apart all the time.
  float enter, leave;
  /// Negative where they surely overlap at the start and at the end.
  float first_gap, last_gap;
};
inline constexpr float kApart = 0x1p127F;
inline constexpr unsigned kEdgeBits = 15, kCornerUnit = 16, kCandidateBits = 127;

inline constexpr int kMostEdges = 256;  ///< to be certified in one call
inline constexpr int kLanes = 8;  ///< as many are read and written as the next multiple of this

/// Each: whether an edge of one outline and a vertex of the other, both moving, are an edge of the
/// Minkowski difference, and the origin crosses it.
struct Edges {
  /// x and y of points or velocities in a row: of the ends of the edge; of the vertex before that of
  /// the other outline, of the vertex, of the one after; of the first body and of the second.
  const double *edge[kMostEdges], *vertex[kMostEdges], *moves[kMostEdges];
  /// 1 where the edge is one of the first outline, else -1: of edges on one line those of the first
  /// come first.
  double of_first[kMostEdges];

  /// The nearest double to when the vertex is on the line of the edge; no number where that is not certain.
  double time[kMostEdges];
  double found[kMostEdges];  ///< the sum of what holds of the below
};
inline constexpr int kUnsure = 1;         ///< a sign is not certain
inline constexpr int kPast = 2;           ///< the time is surely negative
inline constexpr int kFromLeft = 4;       ///< `from` is to the left of the way of the vertex
inline constexpr int kToLeft = 8;         ///< `to` is
inline constexpr int kRatherBefore = 16;  ///< not the vertex but `before` belongs to the edge
inline constexpr int kRatherAfter = 32;   ///< or `after`

struct Kernels {
  /// `near` is 0 where the boxes of both bodies certainly never touch for t in [0, length], else 1.
  /// Of a box x and y of its centre, then of half its size, or more.
  void (*cull_boxes)(const double* boxes, double length, const Moves& moves, int count,
                     double* near);
  /// Of outlines as they move for t in [0, length].
  void (*find_candidates)(const Approach* pairs, int count, float length, Candidates* found);
  void (*certify)(Edges& edges, int count);
};

extern const Kernels kPortable, kBaseline, kAvx2, kAvx512;

}  // namespace flatray::pairs
