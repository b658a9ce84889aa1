#include "collide/near_bodies.h"

#include <cmath>

#include "collide/broad_phase.h"

namespace flatray {

void NearBodies::open(double from, double to, std::span<const std::vector<Stage>> stages) {
  to_ = to;
  std::vector<Bounds> ways;
  for (std::uint32_t i = 0; i < shapes_.size(); ++i)
    ways.push_back(way_of(i, stages[i].back(), from));
  ways_ = BoxGrid(std::move(ways));
}

// Outward by more than rounding of places and of times, theirs and those of their meetings, can be.
Bounds NearBodies::way_of(std::uint32_t body, const Stage& stage, double from) const {
  const Bounds& shape = shapes_[body];
  if (stage.gone || shape.empty()) return {};
  constexpr double kSlack = 0x1p-46;
  const Vec2 at = stage.at + (from - stage.from) * stage.velocity;
  const Vec2 sizes = sizes_of_place(stage, to_) + shape.low.cwiseAbs() + shape.high.cwiseAbs();
  Bounds way = swept({at + shape.low, at + shape.high}, stage.velocity, to_ - from);
  const Vec2 slack =
      kSlack * sizes + Vec2::Constant(0x1p-1060);  // that of rounding to what is hardly a double
  way.low -= slack;
  way.high += slack;
  // Beyond the doubles it may be anywhere.
  if (!way.low.allFinite() || !way.high.allFinite())
    return {{-kInfinity, -kInfinity}, {kInfinity, kInfinity}};
  return way;
}

Bounds bounds_of(std::span<const ShapePart> parts) {
  Bounds box;
  for (const ShapePart& part : parts)
    for (const Vec2& p : part.ring) {
      const Vec2 reach(part.radius, part.radius);
      box.add(Bounds{p - reach, p + reach});
    }
  return box;
}

}  // namespace flatray
