#pragma once
#include <array>
#include <span>
#include <vector>

#include "geom/exact.h"
#include "render/coverage_cell.h"

namespace flatray {

using kernels::Run;

/// Runs of one box: rows from top to bottom, from left to right, none of equal coverage beside a
/// full one.
class RunList {
 public:
  void clear() { begin_ = end_ = 0; }
  /// Runs added from here on are of another region: not joined to those before. Gives their index.
  std::size_t start() { return begin_ = end_; }
  std::span<const Run> runs() const { return {runs_.data(), end_}; }
  /// Joined to the last run where the same goes on.
  void add(int y, int x_begin, int x_end, std::uint32_t steps) {
    if (x_begin >= x_end || steps == 0) return;
    if (end_ > begin_) {
      Run& last = runs_[end_ - 1];
      if (last.y == y && last.x_end == x_begin && last.steps == steps) {
        last.x_end = x_end;
        return;
      }
    }
    *room(1) = {y, x_begin, x_end, steps};
    ++end_;
  }
  /// Room for `most` runs behind the last, of which `keep` adds the first `count`.
  Run* room(std::size_t most) {
    if (runs_.size() < end_ + most) runs_.resize(2 * (end_ + most));
    return runs_.data() + end_;
  }
  void keep(std::size_t count) { end_ += count; }
  /// Takes back what was added since `start`.
  void drop() { end_ = begin_; }

 private:
  std::vector<Run> runs_;
  std::size_t begin_ = 0, end_ = 0;
};

/// For tests: sees every pixel with an edge, its double area and, asked for, the exact one.
class CellAudit {
 public:
  virtual ~CellAudit() = default;
  virtual void see(const CellArea& computed, const Rational& exact) = 0;
};

/// What the edges of a simple path add to one pixel.
struct SimpleCell {
  int column;
  int entering;  ///< directions of those that come in by the row's upper border
  Share share;
};

/// Entries of one row of a box, and the winding just inside its upper left corner.
template <class Entry>
struct ScanRow {
  std::vector<Entry> entries;
  int winding = 0;

  void drop() {
    entries.clear();
    winding = 0;
  }
};

/// The area scan of paths, with its room kept from call to call. One for each thread.
class AreaScan {
 public:
  /// `stop` is asked before each row: true leaves it and all after it out.
  explicit AreaScan(const kernels::SpanKernels& kernels, bool (*stop)() = nullptr)
      : kernels_(kernels), stop_(stop) {}

  /// Adds the runs of the path's edges in `box`; of `chosen` edges only where given (all that meet
  /// the box's rows must be among them).
  CoverageStats scan(const FillPath& path, const std::vector<std::uint32_t>* chosen,
                     const PixelBox& box, RunList& out, CellAudit* audit = nullptr);

 private:
  void cut_edges(const FillPath& path, const std::vector<std::uint32_t>* chosen);
  void cut_edge(const Segment& edge, bool simple);
  template <class Entry>
  void cut_rows(std::uint32_t index, int first, int last, std::vector<ScanRow<Entry>>& rows);
  template <class Entry>
  void cut_row(std::uint32_t index, int row, std::vector<ScanRow<Entry>>& rows);
  template <class Entry>
  void cut_whole_rows(std::uint32_t index, int first, int last, std::vector<ScanRow<Entry>>& rows);
  template <class Entry>
  void scan_row(const FillPath& path, int row, ScanRow<Entry>& work, RunList& out);
  std::uint32_t steps(const FillPath& path, std::span<const Piece> cell, int winding, int row);
  std::uint32_t steps(const FillPath& path, std::span<const SimpleCell> cell, int winding, int row);
  template <class Touching>
  std::uint32_t decide(const CellArea& area, const Touching& touching, FillRule rule, int winding,
                       int column, int row);
  int without_touching(int winding, int column, int row);
  void join_equal();
  void gather(std::span<const Piece> cell);
  void gather(int column, int row);

  const kernels::SpanKernels& kernels_;
  bool (*const stop_)();
  PixelBox box_;
  int first_row_ = 0, last_row_ = -1;  ///< rows with an entry
  std::vector<double> x_, columns_;
  CellAudit* audit_ = nullptr;
  CoverageStats stats_;
  std::vector<ScanEdge> edges_;
  std::vector<ScanRow<Piece>> rows_;
  std::vector<ScanRow<SimpleCell>> simple_rows_;
  std::vector<std::uint32_t> touching_;
  std::vector<ScanEdge> exact_edges_;
  SlabWork slabs_;
};

/// The scan of paths by pixel centres, likewise. A row of centres is a ray: where an edge crosses
/// it, the winding changes from the first centre on or right of the edge.
class CentreScan {
 public:
  explicit CentreScan(const kernels::SpanKernels& kernels) : kernels_(kernels) {}

  CoverageStats scan(const FillPath& path, const std::vector<std::uint32_t>* chosen,
                     const PixelBox& box, RunList& out);

 private:
  struct Step {
    int row, column, change;
  };
  struct FewSteps {
    std::array<Step, 2> steps;
    std::uint8_t count = 0;
  };
  void begin_rows();
  void add_edge(const Segment& edge);
  void add_step(int row, int column, int change);
  void add_runs(FillRule rule, RunList& out);
  void add_runs_of_few(FillRule rule, RunList& out);

  const kernels::SpanKernels& kernels_;
  PixelBox box_;
  CoverageStats stats_;
  std::vector<double> x_, columns_;
  bool few_steps_ =
      true;  ///< at most two in each row so far: they are in `rows_`, else in `steps_`
  int first_row_ = 0, last_row_ = -1;  ///< rows with a step, while there are few
  std::vector<FewSteps> rows_;
  std::vector<Step> steps_;
};

/// Discs and rings: coverage_ring.cpp.
void scan_ring(const FillRing& ring, Coverage mode, const PixelBox& box, RunList& out,
               CoverageStats& stats);

}  // namespace flatray
