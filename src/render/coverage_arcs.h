#pragma once
#include <vector>

#include "render/arc_edge.h"
#include "render/coverage_scan.h"

namespace flatray {

/// The scan of paths with arcs, with its room kept from call to call.
class ArcScan {
 public:
  CoverageStats scan(const FillArcs& arcs, Coverage mode, const PixelBox& box, RunList& out);

 private:
  void add_path(const ArcPath& path);
  void add(const ArcEdge& edge);
  void cut_row(const ArcEdge& edge, int row);
  void walk(const ArcEdge& edge, const RowCut& cut, int row, ScanRow<SimpleCell>& work);
  void scan_row(int row, ScanRow<SimpleCell>& work, RunList& out);
  void cut_centres(const ArcEdge& edge);
  void centre_row(int row, ScanRow<SimpleCell>& work, RunList& out);

  PixelBox box_;
  Coverage mode_ = Coverage::area;
  CoverageStats stats_;
  std::vector<ScanRow<SimpleCell>> rows_;
};

}  // namespace flatray
