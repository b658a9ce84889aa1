#pragma once
// Part of flight.h: how a ray goes on between periodic walls.
#include "precise/flight.h"

namespace flatray {

template <class Number, class Make>
std::optional<Pair<Number>> Flight<Number, Make>::cross_over(const Prospect& next) {
  const Segment& wall = walls_.segment(next.walls.front());
  const auto part = part_at(wall);
  if (!part) return std::nullopt;
  const Pair<Number> met = pair(wall.a) + *part * (pair(wall.b) - pair(wall.a));
  point_ = met;
  const auto crossed = periodic_.crossed_by(
      next.walls, [&](const PeriodicWalls::Side& side) { return leads_out(side.surface); });
  if (!crossed) return std::nullopt;
  for (const PeriodicWalls::Side* side : *crossed) {
    const Pair<Number> shift = pair(side->to()) - pair(side->from());
    course_.moment = course_.moment + cross(shift, course_.direction);
    point_ = point_ + shift;
    departed_ = side->opposite;
    cell_ += side->step;
  }
  course_.here = dot(point_ - pair(course_.about), course_.direction);
  circles_ = crossings_ > 0 && is_same(point_, first_entry_);
  if (crossings_++ == 0) first_entry_ = point_;
  return met;
}

template <class Number, class Make>
template <class See>
std::optional<Number> Flight<Number, Make>::cross_on(const Prospect& last, const See& see) {
  const Number none = course_.make(0);
  if (last.walls.size() != 1) return none;
  const PeriodicWalls::Side& side = *periodic_.find(last.walls.front());
  const int along = 1 - side.axis;
  if (side.axis < 0 || side.from()[along] != side.to()[along]) return none;
  const Pair<Number>& d = course_.direction;
  const Number way = course_.make(side.from()[side.axis]) - course_.make(side.to()[side.axis]);
  const Number t = way / (side.axis == 0 ? d.x : d.y);  // of one cell
  const Number step = t * (along == 0 ? d.x : d.y);
  Number& place = along == 0 ? point_.x : point_.y;
  const Number first = place;
  const auto heading = step.sign();
  if (!heading || *heading == Sign::zero) return none;
  const std::optional<double> end = end_of_free(side.wall, along, place, *heading);
  if (!end) return none;
  const auto cells = ((course_.make(*end) - first) / step).nearest();
  if (!cells || !(*cells > 2)) return none;
  const auto count = static_cast<std::uint32_t>(
      std::min(std::floor(*cells) - 1, double{kMostCrossings} - crossings_));
  if ((course_.make(*end) - first - course_.make(count) * step).sign() != *heading) return none;
  for (std::uint32_t i = 1; i <= count; ++i) {
    place = first + course_.make(i) * step;
    const auto at = place.nearest();
    if (!at) return std::nullopt;
    Vec2 from = side.from(), to = side.to();
    from[along] = to[along] = *at;
    see(from, to, side.step);
    cell_ += side.step;
  }
  const Number back = side.axis == 0 ? -(way * d.y) : way * d.x;  // way back across d
  course_.moment = course_.moment + course_.make(count) * back;
  course_.here = dot(point_ - pair(course_.about), course_.direction);
  crossings_ += count;
  return course_.make(count) * t;
}

template <class Number, class Make>
std::optional<double> Flight<Number, Make>::end_of_free(const Segment& wall, int axis,
                                                        const Number& place, Sign heading) const {
  Bounds others;
  for (std::uint32_t i = 0; i < walls_.size(); ++i) {
    if (periodic_.has(i)) continue;
    Bounds box = walls_.visit(i, [](const auto& one) { return bounds_of(one); });
    if (const auto* copy = periodic_.find_copy(i)) {  // the box is that of its rounded centre
      const Bounds of = bounds_of(walls_.arc(copy->of));
      const auto size = [](const Bounds& b) {
        return b.low.cwiseAbs().cwiseMax(b.high.cwiseAbs()).maxCoeff();
      };
      const double off = 0x1p-49 * (size(box) + size(of));
      box.low -= Vec2::Constant(off);
      box.high += Vec2::Constant(off);
    }
    others.add(box);
  }
  double low = std::min(wall.a[axis], wall.b[axis]), high = std::max(wall.a[axis], wall.b[axis]);
  if (!others.empty()) {
    if ((course_.make(others.low[axis]) - place).sign() == Sign::positive)
      high = std::min(high, others.low[axis]);
    else if ((place - course_.make(others.high[axis])).sign() == Sign::positive)
      low = std::max(low, others.high[axis]);
    else
      return std::nullopt;
  }
  return heading == Sign::positive ? high : low;
}

}  // namespace flatray
