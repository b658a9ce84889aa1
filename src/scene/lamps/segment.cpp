#include "scene/lambert.h"
#include "scene/lamp.h"

namespace flatray::segment_lamp {
namespace {

constexpr KeyInfo kKeys[] = {{"from", "[x, y] or a curve", kRequired},
                             {"to", "[x, y] or a curve", kRequired},
                             {"both_sides", "true or false", "false"}};

class Line : public Emitter {
 public:
  Line(const Vec2& from, const Vec2& to, bool both_sides)
      : from_(from), along_(to - from), both_sides_(both_sides) {
    unit_ = along_ / along_.cwiseAbs().maxCoeff();
    unit_ /= size_of(unit_);
  }

  Emitted emit(const double* u) const override {
    const bool right = both_sides_ && u[0] < 0.5;
    const double share = both_sides_ ? 2 * u[0] - (right ? 0 : 1) : u[0];
    const Vec2 left(-unit_.y(), unit_.x()), normal = (right ? -1.0 : 1.0) * left;
    return {from_ + u[1] * along_, lambert_direction(normal, unit_, share)};
  }
  std::optional<LampLine> line() const override {
    return LampLine{{from_, from_ + along_}, std::nullopt, false,
                    size_of(along_),         true,         both_sides_};
  }
  double seen_part(double room) const override { return size_of(along_) / room; }

 private:
  Vec2 from_, along_, unit_;
  bool both_sides_;
};

Result<std::unique_ptr<const Emitter>> build(Args& args) {
  const Vec2 from = args.point("from"), to = args.point("to");
  const bool both_sides = args.flag("both_sides");
  args.vanish(from == to);
  if (from == to)
    return fail(args.place("to"), "lamp.segment.to is where it begins", "write another point");
  return std::make_unique<Line>(from, to, both_sides);
}

}  // namespace

extern const LampType entry = {
    "segment", "a straight line that shines to its left, as a matt surface does",
    kKeys,     2,
    &build,    LampSeen::line};

}  // namespace flatray::segment_lamp
