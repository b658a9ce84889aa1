#include "trace/lane_tracer.h"

namespace flatray::grid_tracer {

extern const Tracer entry = {"grid", "walls in cells that rays walk through, one in each lane",
                             true, [](const Surfaces& walls, Isa isa, unsigned threads) {
                               return trace_in_lanes(walls, CellGrid::build(walls, threads), isa,
                                                     threads);
                             }};

}  // namespace flatray::grid_tracer
