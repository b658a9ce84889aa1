#pragma once
#include <span>
#include <vector>

#include "geom/exact.h"
#include "render/coverage_cell.h"

namespace flatray {

using kernels::Run;

/// Runs of one box: rows from top to bottom, from left to right, neighbours of equal coverage
/// joined.
class RunList {
 public:
  void clear() { runs_.clear(); }
  const std::vector<Run>& runs() const { return runs_; }
  void add(int y, int x_begin, int x_end, std::uint32_t steps) {
    if (x_begin >= x_end || steps == 0) return;
    if (!runs_.empty()) {
      Run& last = runs_.back();
      if (last.y == y && last.x_end == x_begin && last.steps == steps) {
        last.x_end = x_end;
        return;
      }
    }
    runs_.push_back({y, x_begin, x_end, steps});
  }

 private:
  std::vector<Run> runs_;
};

/// For tests: sees every pixel with an edge, its double area and, asked for, the exact one.
class CellAudit {
 public:
  virtual ~CellAudit() = default;
  virtual void see(const CellArea& computed, const Rational& exact) = 0;
};

/// The area scan of paths, with its room kept from call to call. One for each thread.
class AreaScan {
 public:
  /// Adds the runs of the path's edges in `box`; of `chosen` edges only where given (all that meet
  /// the box's rows must be among them).
  CoverageStats scan(const FillPath& path, const std::vector<std::uint32_t>* chosen,
                     const PixelBox& box, RunList& out, CellAudit* audit = nullptr);

 private:
  void cut_edges(const FillPath& path, const std::vector<std::uint32_t>* chosen);
  void cut_edge(const Segment& edge);
  void scan_row(const FillPath& path, int row, RunList& out);
  std::uint32_t cell_steps(const FillPath& path, std::span<const Piece> cell, int winding, int row);
  Rational exact_cell(const FillPath& path, std::span<const Piece> cell, int winding, int row);

  PixelBox box_;
  CellAudit* audit_ = nullptr;
  CoverageStats stats_;
  std::vector<ScanEdge> edges_;
  std::vector<PieceRow> rows_;
  std::vector<std::uint32_t> touching_;
  std::vector<ScanEdge> exact_edges_;
  SlabWork slabs_;
};

/// The runs whose pixel centres lie inside a path: coverage_centre.cpp.
void scan_centres(const FillPath& path, const std::vector<std::uint32_t>* chosen,
                  const PixelBox& box, RunList& out, CoverageStats& stats);
/// Discs and rings: coverage_ring.cpp.
void scan_ring(const FillRing& ring, Coverage mode, const PixelBox& box, RunList& out,
               CoverageStats& stats);

}  // namespace flatray
