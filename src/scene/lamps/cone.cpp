#include <fmt/core.h>

#include <cmath>
#include <numbers>

#include "base/number_text.h"
#include "geom/turn.h"
#include "scene/lamp.h"

namespace flatray::cone_lamp {
namespace {

constexpr KeyInfo kKeys[] = {{"spread", "degrees or a curve", kRequired}};

class Cone : public Emitter {
 public:
  explicit Cone(double spread) : spread_(spread) {}
  Emitted emit(const double* u) const override {
    const Turn out = turn((u[0] - 0.5) * spread_);
    return {{0, 0}, {out.cos, out.sin}};
  }
  std::optional<Sight> sight(const Vec2& at) const override {
    const Turn half = turn(spread_ / 2);
    const bool is_within = std::fabs(at.y()) * half.cos <= at.x() * half.sin;
    const bool sees = half.cos < 0 ? at.x() >= 0 || is_within : at.x() >= 0 && is_within;
    if (spread_ == 0 || !sees) return std::nullopt;
    return Sight{{0, 0}, 1 / (spread_ * size_of(at))};
  }
  bool is_one_ray() const override { return spread_ == 0; }
  double seen_part(double /*room*/) const override { return spread_ / (2 * std::numbers::pi); }

 private:
  double spread_;  // radians
};

Result<std::unique_ptr<const Emitter>> build(Args& args) {
  const double spread = args.number("spread");
  if (!(spread >= 0 && spread <= 360))
    return fail(args.place("spread"),
                fmt::format("lamp.cone.spread is {}, not between 0 and 360", number_text(spread)),
                "write the whole angle of the cone in degrees");
  return std::make_unique<Cone>(radians(spread));
}

}  // namespace

extern const LampType entry = {"cone", "a point that shines alike in all directions of a cone",
                               kKeys,  1,
                               &build, LampSeen::points};

}  // namespace flatray::cone_lamp
