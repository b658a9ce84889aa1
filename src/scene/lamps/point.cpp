#include <numbers>

#include "geom/turn.h"
#include "scene/lamp.h"

namespace flatray::point_lamp {
namespace {

class AllAround : public Emitter {
 public:
  Emitted emit(const double* u) const override {
    const Turn out = turn(u[0] * (2 * std::numbers::pi));
    return {{0, 0}, {out.cos, out.sin}};
  }
  std::optional<Sight> sight(const Vec2& at) const override {
    return Sight{{0, 0}, 1 / (2 * std::numbers::pi * size_of(at))};
  }
};

Result<std::unique_ptr<const Emitter>> build(Args&) { return std::make_unique<AllAround>(); }

}  // namespace

extern const LampType entry = {
    "point", "a point that shines alike in all directions", {}, 1, &build, LampSeen::points};

}  // namespace flatray::point_lamp
