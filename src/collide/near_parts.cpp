#include "collide/near_parts.h"

#include <algorithm>
#include <numeric>

#include "collide/broad_phase.h"
#include "collide/near_bodies.h"

namespace flatray {
namespace {

constexpr std::size_t kFew = 16;
const Bounds kEverywhere{{-kInfinity, -kInfinity}, {kInfinity, kInfinity}};

// A box around all places of a part from 0 to a time. What swept() adds is more than rounding of its box, of the
// velocity and of the way loses.
Bounds way_of(const ShapePart& part, const Vec2& velocity, double length) {
  const Vec2 way = velocity * length;
  if (part.curve || !way.allFinite()) return kEverywhere;
  const Bounds box = swept(bounds_of({&part, 1}), velocity, length);
  return box.low.allFinite() && box.high.allFinite() ? box : kEverywhere;
}

std::vector<Bounds> boxes_of(std::span<const ShapePart> parts) {
  std::vector<Bounds> boxes;
  if (parts.size() >= kFew)
    for (const ShapePart& part : parts) boxes.push_back(way_of(part, {0, 0}, 0));
  return boxes;
}

}  // namespace

NearParts::NearParts(std::span<const ShapePart> parts)
    : count_(parts.size()), boxes_(boxes_of(parts)) {}

std::vector<std::size_t> NearParts::near(const ShapePart& part, const Vec2& velocity,
                                         Range within) const {
  if (count_ >= kFew && within.low >= 0 && within.high < kInfinity) {
    std::vector<std::size_t> found = boxes_.near(way_of(part, velocity, within.high));
    std::ranges::sort(found);
    return found;
  }
  std::vector<std::size_t> all(count_);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

}  // namespace flatray
