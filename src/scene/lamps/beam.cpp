#include <cmath>

#include "scene/lamp.h"

namespace flatray::beam_lamp {
namespace {

constexpr KeyInfo kKeys[] = {{"width", "number or a curve", kRequired}};

class Beam : public Emitter {
 public:
  explicit Beam(double width) : width_(width) {}
  Emitted emit(const double* u) const override { return {{0, (u[0] - 0.5) * width_}, {1, 0}}; }
  std::optional<Sight> sight(const Vec2& at) const override {
    if (!(at.x() > 0 && std::abs(at.y()) <= width_ / 2)) return std::nullopt;
    return Sight{{0, at.y()}, 1 / width_};
  }
  std::optional<LampLine> starts() const override {
    return LampLine{{{0, -width_ / 2}, {0, width_ / 2}}, std::nullopt, false, width_, false, true};
  }
  double seen_part(double room) const override { return width_ / room; }

 private:
  double width_;
};

Result<std::unique_ptr<const Emitter>> build(Args& args) {
  return std::make_unique<Beam>(args.size("width"));
}

}  // namespace

extern const LampType entry = {"beam",          "parallel rays side by side", kKeys, 1, &build,
                               LampSeen::points};

}  // namespace flatray::beam_lamp
