#pragma once
#include <span>
#include <vector>

#include "trace/tracer.h"

namespace flatray {

/// A small room of polygons at one scale and one distance from the origin.
struct SweepCell {
  double scale_log2 = 0, offset_log2 = 0;
  std::uint64_t rays = 0;
  std::vector<std::uint64_t> wrong{};  ///< by tracer: of the wall, or of whether there is one
  std::vector<std::uint64_t> off{};  ///< of the others: of class or end, or t more than an ulp off
};

/// The logarithms of what is swept: -1000 to 1000.
std::vector<double> sweep_steps();

/// Walls of twelve triangles and quadrangles and rays at their vertices and past them, times
/// 2^scale_log2 and moved by 2^offset_log2 along both axes; whatever that leaves of them in doubles
/// is what the tracers and the oracle are asked about.
///
/// Needs   tracers that are not missing.
/// Cost    some ms.
SweepCell sweep_cell(std::span<const Tracer* const> tracers, std::uint64_t seed, double scale_log2,
                     double offset_log2);

}  // namespace flatray
