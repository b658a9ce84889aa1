#pragma once
#include <optional>

#include "render/coverage_scan.h"
#include "render/monotone_ring.h"

namespace flatray {

/// The scan of monotone rings: a row has a left and a right boundary, and no more. Gives the runs
/// of `AreaScan` and `CentreScan`, or leaves the ring to them. One for each thread.
class MonotoneScan {
 public:
  explicit MonotoneScan(const kernels::SpanKernels& kernels) : kernels_(kernels) {}

  /// Adds the runs of a ring in `box`. Nothing, and none added, where the error bounds leave a
  /// pixel open.
  std::optional<CoverageStats> scan(MonotoneRing ring, Coverage mode, const PixelBox& box,
                                    RunList& out);

 private:
  struct Side;
  struct Cut;
  struct Decider;

  bool scan_centres(MonotoneRing ring, RunList& out);
  bool scan_area(MonotoneRing ring, RunList& out);
  void measure(MonotoneRing ring);
  void enter(Side& side);
  void next_edge(Side& side);
  void cut_row(Side& side, double end);
  void cut(Side& side, double x, double y);
  template <bool kLeft>
  Run* put_side(int row, const Cut& cut, Run* run);
  bool add_whole_row(int row, Side& a, Side& b, RunList& out);
  void add_row(int row, const Side& left, const Side& right, RunList& out);
  Run* put_pixels(int row, int column, int end, Run* run);

  const kernels::SpanKernels& kernels_;
  PixelBox box_;
  CoverageStats stats_;
  double top_ = 0, bottom_ = 0;     ///< of the ring
  double error_x_ = 0, slack_ = 0;  ///< of a cut, in pixels; of an area, in steps
  bool doubt_ = false;
  /// Of the row's area from column to column of the box; all 0 between rows.
  std::vector<double> changes_;
  double area_ = 0;  ///< sum of the changes so far
  std::vector<std::int32_t> room_;
};

}  // namespace flatray
