#pragma once
#include <stddef.h>
#include <stdint.h>

/// Row kernels of the software back end, one table for each instruction-set tier. Plain types only:
/// what a tier compiles must not leave its file. All tiers give the same bits: a lane is one
/// channel of one pixel or one row of one edge, and products and sums are rounded one by one.
namespace flatray::kernels {

constexpr uint32_t kFullSteps = 64770;

/// Pixels [x_begin, x_end) of row y with one coverage > 0, in steps of 1 / kFullSteps.
struct Run {
  int32_t y, x_begin, x_end;
  uint32_t steps;
};

/// Middle of a step as a share of the pixel; exactly 0 and 1 at the ends.
static inline float share(uint32_t steps) {
  if (steps == 0 || steps >= kFullSteps) return steps == 0 ? 0.0F : 1.0F;
  return ((float)steps + 0.5F) / (float)kFullSteps;
}

/// Premultiplied linear RGBA: rows of `width` pixels, the first at film position (x, y).
struct Target {
  float* rgba;
  int32_t x, y, width;
};

/// Line x = x_ref + (y - y_ref) * slope, kept within [low, high]; x is right to `error`.
struct EdgeLine {
  double x_ref, y_ref, slope, low, high, error;
};

/// Corner of a ring in film coordinates.
struct Corner {
  double x, y;
};

/// Rectangle of pixels.
struct RowBox {
  int32_t x, y, width, height;
};

/// Where no column is certain: on a border between two, or within the error of one.
constexpr double kNoColumn = 0x1p60;
/// Entries beyond `count` a kernel may write.
constexpr size_t kSlack = 7;
/// In place of a number of runs: some pixel needs exact arithmetic.
constexpr size_t kUndecided = (size_t)-1;

struct SpanKernels {
  /// Lays a premultiplied colour over the runs: new = colour * share + old * (1 - alpha * share).
  void (*blend_runs)(const Target& target, const Run* runs, size_t count, const float* colour);
  /// x of an edge at y, y + 1, ... (`count` of them) and floor(x + offset), or kNoColumn.
  /// Needs room for count + kSlack entries.
  void (*edge_columns)(const EdgeLine& edge, double y, size_t count, double offset, double* x,
                       double* column);
  /// The pixels of a box whose centres are inside a ring, a run a row at most; kUndecided where a
  /// column is within the error of the next. A centre on the outline is in doubt too.
  /// Needs   a ring as MonotoneRing gives it; room for 2 * height + 4 * kSlack numbers and for
  ///         height runs.
  size_t (*centre_runs)(const Corner* ring, size_t count, const RowBox& box, int32_t* room,
                        Run* runs);
  /// Sets `count` pixels.
  void (*fill)(float* rgba, size_t count, const float* colour);
};

extern const SpanKernels portable_kernels, baseline_kernels, avx2_kernels, avx512_kernels;

}  // namespace flatray::kernels
