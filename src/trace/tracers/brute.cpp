#include "trace/lane_tracer.h"

namespace flatray::brute_tracer {

extern const Tracer entry = {"brute", "every wall against every ray, one in each lane", true,
                             [](const Surfaces& walls, Isa isa, unsigned threads) {
                               return trace_in_lanes(walls, CellGrid::build_list(walls), isa,
                                                     threads);
                             }};

}  // namespace flatray::brute_tracer
