#include <cmath>

#include "geom/turn.h"
#include "scene/material.h"

namespace flatray::mix_material {
namespace {

constexpr KeyInfo kKeys[] = {{"diffuse", "number", "0"},
                             {"isotropic", "number", "0"},
                             {"mirror", "number", "0"},
                             {"pass", "number", "0"},
                             {"colour", "\"#rrggbb\"", "\"#ffffff\""},
                             {"mirror_turn", "[degrees, degrees]", "[0, 0]"}};

// A mixture on a wall out of which its mirror is turned.
class TurnedMix : public Scatterer {
 public:
  TurnedMix(std::unique_ptr<const Scatterer> mix, double from, double to)
      : mix_(std::move(mix)), from_(from), by_(to - from) {}

  Departure scatter(const Arrival& arrival, double u) const override {
    Departure departure = mix_->scatter(arrival, u);
    if (departure.way != Departure::Way::mirrored) return departure;
    departure.way = Departure::Way::scattered;
    departure.direction = mirrored(arrival);
    return departure;
  }
  bool depends_on_place() const override { return true; }
  bool colours() const override { return mix_->colours(); }

 private:
  // Which side of the mirror is seen makes no difference.
  Vec2 mirrored(const Arrival& arrival) const {
    const Turn by = turn(from_ + arrival.along * by_);
    const Vec2& n = arrival.normal;
    const Vec2 normal(by.cos * n.x() - by.sin * n.y(), by.sin * n.x() + by.cos * n.y());
    const Vec2 out = arrival.direction - 2 * arrival.direction.dot(normal) * normal;
    return out / std::sqrt(out.dot(out));
  }

  std::unique_ptr<const Scatterer> mix_;
  double from_, by_;  // radians, from the first end of a wall to the other
};

Result<std::unique_ptr<const Scatterer>> build(Args& args) {
  const double numbers[] = {args.number("diffuse"), args.number("isotropic"), args.number("mirror"),
                            args.number("pass")};
  double sum = 0;
  for (const double number : numbers) sum += number >= 0 ? number : 2;
  if (sum == 0)
    args.warning(args.where, "the material sends no light on", "write \"absorb\", which says so");
  constexpr double kRounding =
      0x1p-50;  // that decimals and three sums leave, as of 0.1 + 0.2 + 0.7
  if (!(sum <= 1 + kRounding))
    return fail(args.where, "the parts of the mix are below 0 or more than 1 together",
                "write how much of the light goes each way; the rest is absorbed");
  const Reflectance colour = read_reflectance(args);
  const double part = colour.part;
  const Vec2 turns = args.point("mirror_turn");
  constexpr double kMostTurn = 1e6;
  if (!(turns.cwiseAbs().maxCoeff() <= kMostTurn))
    args.problem("mirror_turn", "is more than 1000000 degrees",
                 "write how far the mirror is turned");
  auto mix = mixture(
      {part * numbers[0], part * numbers[1], part * numbers[2], part * numbers[3], colour.tint});
  if (turns == Vec2(0, 0)) return mix;
  return std::make_unique<TurnedMix>(std::move(mix), radians(turns.x()), radians(turns.y()));
}

}  // namespace

extern const MaterialType entry = {
    "mix", "parts of the light are scattered, mirrored or let through; the rest is absorbed", kKeys,
    &build};

}  // namespace flatray::mix_material
