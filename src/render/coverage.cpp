#include "render/coverage.h"

#include "render/coverage_arcs.h"
#include "render/coverage_monotone.h"
#include "render/select_kernels.h"

namespace flatray {
namespace {

void pass_on(const RunList& list, const RunSink& sink) {
  for (const Run& run : list.runs()) sink(run.y, run.x_begin, run.x_end, run.steps);
}

}  // namespace

CoverageStats scan(const FillPath& path, Coverage mode, const PixelBox& box, const RunSink& sink) {
  RunList list;
  const kernels::SpanKernels& kernels = span_kernels(active_isa());
  std::vector<Corner> ring;
  std::optional<CoverageStats> stats;
  if (append_monotone_ring(path, path.edges.size(), ring))
    stats = MonotoneScan(kernels).scan(ring, mode, box, list);
  if (!stats)
    stats = mode == Coverage::area ? AreaScan(kernels).scan(path, nullptr, box, list)
                                   : CentreScan(kernels).scan(path, nullptr, box, list);
  pass_on(list, sink);
  return *stats;
}

CoverageStats scan(const FillRing& ring, Coverage mode, const PixelBox& box, const RunSink& sink) {
  RunList list;
  CoverageStats stats;
  scan_ring(ring, mode, box, list, stats);
  pass_on(list, sink);
  return stats;
}

CoverageStats scan(const FillArcs& arcs, Coverage mode, const PixelBox& box, const RunSink& sink) {
  RunList list;
  const CoverageStats stats = ArcScan().scan(arcs, mode, box, list);
  pass_on(list, sink);
  return stats;
}

}  // namespace flatray
