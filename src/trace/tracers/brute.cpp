#include "trace/lane_tracer.h"

namespace flatray::brute_tracer {
namespace {

std::unique_ptr<Accelerator> build(const Surfaces& walls, Isa isa, unsigned) {
  return trace_in_lanes(walls, &CellGrid::build_list, isa);
}

}  // namespace

extern const Tracer entry = {"brute", "every wall against every ray, one in each lane", true,
                             &build};

}  // namespace flatray::brute_tracer
