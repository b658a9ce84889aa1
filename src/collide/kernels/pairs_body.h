// The kernels of the contact of many pairs, written once. Each tier's file includes this with
// FLATRAY_TIER and FLATRAY_LANES set, after what the intrinsics need. Meaning of what goes in and out:
// pairs.h.
#include "collide/kernels/pairs.h"
#include "geom/error_bounds.h"

namespace flatray::pairs {
namespace FLATRAY_TIER {
namespace {
#include "trace/kernels/vector.h"
// After it.
#include "collide/kernels/box_cull_body.h"
#include "collide/kernels/candidates_body.h"
#include "collide/kernels/certify_body.h"
}  // namespace
}  // namespace FLATRAY_TIER

const Kernels FLATRAY_KERNELS = {&FLATRAY_TIER::cull_boxes, &FLATRAY_TIER::find_candidates,
                                 &FLATRAY_TIER::certify};

}  // namespace flatray::pairs
