#include "trace/plain_polygons.h"

namespace flatray::cyrus_beck_tracer {

extern const Tracer entry = {
    "cyrus-beck",
    "the paper's method, convex polygon by convex polygon, in plain double precision: not exact",
    false, [](const Surfaces& walls, Isa, unsigned) -> std::unique_ptr<Accelerator> {
      return std::make_unique<plain::Polygons<double>>(walls);
    }};

}  // namespace flatray::cyrus_beck_tracer
