#include "trace/lane_tracer.h"

namespace flatray::grid_tracer {
namespace {

std::unique_ptr<Accelerator> build(const Surfaces& walls, Isa isa, unsigned threads) {
  return trace_in_lanes(
      walls, [&](const Surfaces& given) { return CellGrid::build(given, threads); }, isa);
}

}  // namespace

extern const Tracer entry = {"grid", "walls in cells that rays walk through, one in each lane",
                             true, &build};

}  // namespace flatray::grid_tracer
