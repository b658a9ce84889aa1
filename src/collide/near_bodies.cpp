#include "collide/near_bodies.h"

#include <algorithm>

namespace flatray {

NearBodies::NearBodies(std::vector<Bounds> shapes)
    : shapes_(std::move(shapes)), boxes_(shapes_.size()), seen_(shapes_.size(), 0) {}

void NearBodies::open(double from, double to, std::span<const Stage* const> stages) {
  to_ = to;
  for (std::uint32_t i = 0; i < boxes_.size(); ++i)
    boxes_[i] = stages[i] == nullptr ? Bounds{} : way_of(i, *stages[i], from);
  put_in_cells();
}

void NearBodies::put_in_cells() {
  constexpr std::size_t kMostAcross = 1024;
  std::vector<double> widths;
  for (const Bounds& box : boxes_)
    if (!box.empty()) widths.push_back(box.size().maxCoeff());
  const auto middle = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2);
  if (!widths.empty()) std::nth_element(widths.begin(), middle, widths.end());
  width_ = !widths.empty() && *middle > 0 && *middle < kInfinity ? *middle : 1;
  across_ = 1;
  while (across_ < kMostAcross && across_ * across_ < widths.size()) across_ *= 2;
  first_.assign(across_ * across_, kNone);
  entries_.clear();
  large_.clear();
  for (std::uint32_t i = 0; i < boxes_.size(); ++i)
    if (!boxes_[i].empty()) put_in_cells(i);
  most_kept_ = 2 * (entries_.size() + large_.size()) + boxes_.size();
}

void NearBodies::put_in_cells(std::uint32_t body) {
  const bool is_small = each_list(boxes_[body], [&](std::uint32_t& first) {
    entries_.push_back({body, first});
    first = static_cast<std::uint32_t>(entries_.size() - 1);
  });
  if (!is_small) large_.push_back(body);
}

void NearBodies::change(std::uint32_t body, const Stage& stage) {
  boxes_[body] = way_of(body, stage, stage.from);
  if (boxes_[body].empty()) return;
  put_in_cells(body);
  // Boxes of ways that are gone stay in their cells: many would be looked at for each that counts.
  if (entries_.size() + large_.size() > most_kept_) put_in_cells();
}

// Outward by more than rounding of places and of times, theirs and those of their meetings, can be.
Bounds NearBodies::way_of(std::uint32_t body, const Stage& stage, double from) const {
  const Bounds& shape = shapes_[body];
  if (stage.gone || shape.empty()) return {};
  constexpr double kSlack = 0x1p-46;
  const Vec2 at = stage.at + (from - stage.from) * stage.velocity;
  const Vec2 speed = stage.velocity.cwiseAbs();
  const Vec2 sizes = stage.at.cwiseAbs() + (std::fabs(to_) + std::fabs(from)) * speed +
                     shape.low.cwiseAbs() + shape.high.cwiseAbs();
  Bounds way = swept({at + shape.low, at + shape.high}, stage.velocity, to_ - from);
  way.low -= kSlack * sizes;
  way.high += kSlack * sizes;
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
