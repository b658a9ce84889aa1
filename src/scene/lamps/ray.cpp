#include "scene/lamp.h"

namespace flatray::ray_lamp {
namespace {

class OneRay : public Emitter {
 public:
  Emitted emit(const double*) const override { return {}; }
};

Result<std::unique_ptr<const Emitter>> build(Args&) { return std::make_unique<OneRay>(); }

}  // namespace

extern const LampType entry = {"ray", "one ray without width", {}, 0, &build};

}  // namespace flatray::ray_lamp
