#include "trace/plain_polygons.h"

namespace flatray::cyrus_beck_float_tracer {

extern const Tracer entry = {
    "cyrus-beck-float",
    "the paper's method, convex polygon by convex polygon, in plain single precision: not exact",
    false, [](const Surfaces& walls, Isa, unsigned) -> std::unique_ptr<Accelerator> {
      return std::make_unique<plain::Polygons<float>>(walls);
    }};

}  // namespace flatray::cyrus_beck_float_tracer
