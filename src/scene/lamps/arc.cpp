#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "geom/turn.h"
#include "scene/lambert.h"
#include "scene/lamp.h"
#include "scene/outlines/arcs.h"

namespace flatray::arc_lamp {
namespace {

constexpr KeyInfo kKeys[] = {{"radius", "number or a curve", kRequired},
                             {"from", "degrees or a curve", "0"},
                             {"to", "degrees or a curve", "360"},
                             {"inward", "true or false", "false"}};

class Arc : public Emitter {
 public:
  Arc(double radius, double from, double sweep, bool inward)
      : radius_(radius), from_(from), sweep_(sweep), out_(inward ? -1 : 1) {}

  Emitted emit(const double* u) const override {
    const Turn place = turn(from_ + u[1] * sweep_);
    const Vec2 normal(place.cos, place.sin), along(-place.sin, place.cos);
    return {radius_ * normal, lambert_direction(out_ * normal, along, u[0])};
  }
  std::optional<LampLine> line() const override {
    const Turn first = turn(std::min(from_, from_ + sweep_));
    const Turn last = turn(std::max(from_, from_ + sweep_));
    const double sweep = std::abs(sweep_);
    return LampLine{{radius_ * Vec2(first.cos, first.sin), radius_ * Vec2(last.cos, last.sin)},
                    Circle{{0, 0}, radius_},
                    sweep >= radians(360),
                    radius_ * sweep,
                    out_<0, out_> 0};
  }
  double seen_part(double room) const override { return radius_ * std::abs(sweep_) / room; }

 private:
  double radius_, from_, sweep_, out_;
};

Result<std::unique_ptr<const Emitter>> build(Args& args) {
  const double radius = args.size("radius");
  const double from = args.number("from", 0), to = args.number("to", 360);
  const bool inward = args.flag("inward");
  args.vanish(from == to);
  if (from == to)
    return fail(args.place("to"), "lamp.arc.to is where it begins", "write another angle");
  const bool is_whole = is_whole_turn(from, to);
  if (!is_whole && !(std::abs(to - from) <= 360))
    return fail(args.place("to"),
                fmt::format("lamp.arc.to is {} degrees from lamp.arc.from, more than a whole turn",
                            number_text(std::abs(to - from))),
                "write degrees of which the difference is at most 360");
  const double sweep = is_whole ? std::copysign(360, to - from) : to - from;
  return std::make_unique<Arc>(radius, radians(from), radians(sweep), inward);
}

}  // namespace

extern const LampType entry = {
    "arc", "an arc that shines outward, as a matt surface does", kKeys, 2, &build, LampSeen::line};

}  // namespace flatray::arc_lamp
