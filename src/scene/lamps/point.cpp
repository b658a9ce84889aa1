#include <numbers>

#include "geom/turn.h"
#include "scene/lamp.h"

namespace flatray::lamps {
namespace {

class AllAround : public Emitter {
 public:
  Emitted emit(const double* u) const override {
    const Turn out = turn(u[0] * (2 * std::numbers::pi));
    return {{0, 0}, {out.cos, out.sin}};
  }
};

Result<std::unique_ptr<const Emitter>> build(Args&) { return std::make_unique<AllAround>(); }

}  // namespace

extern const LampType point = {
    "point", "a point that shines alike in all directions", {}, 1, &build};

}  // namespace flatray::lamps
