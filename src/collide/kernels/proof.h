#pragma once

// What the kernels that prove edges of a Minkowski difference take and give: plain data only, as in
// sweep.h. They work in doubles, and say so where those leave a doubt; so every tier gives the same
// answers.
namespace flatray::proof {

inline constexpr int kMost = 256;  ///< in one call
inline constexpr int kLanes = 8;   ///< as many are read as the next multiple of this

/// Each: whether an edge of one shape and a vertex of the other, both moving, are an edge of the
/// difference, and the origin crosses it.
struct Proofs {
  /// x and y of points or velocities in a row: of the ends of the edge; of the vertex before that of
  /// the other shape, of the vertex, of the one after; of the first shape and of the second.
  const double *edge[kMost], *vertex[kMost], *moves[kMost];
  /// 1 where the edge is one of the first shape, else -1: of edges on one line those of the first
  /// shape come first.
  double of_first[kMost];

  double time[kMost];   ///< nearest double to when the vertex is on the line of the edge
  double found[kMost];  ///< the sum of what holds of the below
};

inline constexpr int kUnsure = 1;         ///< a sign is not certain
inline constexpr int kNoTime = 2;         ///< `time` is not
inline constexpr int kPast = 4;           ///< it is surely negative
inline constexpr int kFromLeft = 8;       ///< `from` is to the left of the way of the vertex
inline constexpr int kToLeft = 16;        ///< `to` is
inline constexpr int kRatherBefore = 32;  ///< not the vertex but `before` belongs to the edge
inline constexpr int kRatherAfter = 64;   ///< or `after`

using Kernel = void (*)(Proofs& proofs, int count);

}  // namespace flatray::proof
