#include "collide/frame_bodies.h"

#include <algorithm>
#include <set>

#include "anim/motion.h"
#include "collide/broad_phase.h"

namespace flatray {
namespace {

// Of what turns a box around all its angles, by its farthest point; empty without a shape.
Bounds still_box(const Shape& shape, const Pose& place, bool turns) {
  if (!turns) return shape_bounds(shape, place);
  const Bounds own = shape_bounds(shape, Pose{{0, 0}, 1, 0, place.scale});
  if (own.empty()) return {};
  const double reach =
      (1 + 0x1p-40) * Vec2(own.low.cwiseAbs().cwiseMax(own.high.cwiseAbs())).stableNorm();
  return {place.at - Vec2(reach, reach), place.at + Vec2(reach, reach)};
}

// Times of [0, 1] in seconds, as `at` has them; what is proven stays so.
template <class At>
void stretch(MeetingPart& part, const At& at) {
  const double from = at(0), to = at(1), low = at(part.times.low), high = at(part.times.high);
  if (part.width == 0) {
    part.times = {low, high};
    return;
  }
  const double rounding = 0x1p-50 * std::fabs(to);
  const double end = std::min(at(part.times.low + part.width) + rounding, to);
  part.times = {std::max(low - rounding, from), std::max(high, end)};
  part.width = (1 + 0x1p-50) * (end - part.times.low);
}

// Whether a motion begins and ends where the frames show it, and does not jump at the time of one.
bool shows(const RigidMotion& motion, const Vec2& now, const Vec2& next) {
  const double rounding = motion.doubt + 0x1p-40 * motion.at.sum(1);
  return (motion.at.c[0] - now).cwiseAbs().maxCoeff() <= rounding &&
         (motion.at.c[0] + motion.at.c[1] - next).cwiseAbs().maxCoeff() <= rounding;
}

}  // namespace

FrameBodies::FrameBodies(const Timeline& timeline, Outline outline, unsigned frame,
                         unsigned next_frame, std::span<const EntityState> now,
                         std::span<const EntityState> next)
    : scene_(timeline.scene()),
      motion_(timeline),
      outline_(outline),
      frame_(frame),
      from_((frame - 1) / scene_.fps),
      to_((next_frame - 1) / scene_.fps),
      now_(now) {
  for (std::uint32_t i = 0; i < now.size(); ++i) {
    const double scale = now[i].scale;
    goes_straight_.push_back(motion_.knots(i, std::nullopt, from_, to_).empty());
    CarriedShape carried{shape(i), {}};
    if (goes_straight_[i]) carried.way = motion_.between(i, std::nullopt, frame_, from_, to_);
    goes_straight_[i] = goes_straight_[i] && carried.goes_straight() &&
                        shows(carried.way.motion, now[i].at, next[i].at);
    doubts_.push_back(carried.way.motion.doubt);
    straight_.push_back(
        {shape(i), pose(now[i].at, carried.way.motion.angle.c[0], scale), next[i].at - now[i].at});
  }
}

const Shape* FrameBodies::shape(std::uint32_t entity) const {
  return &shape_of(scene_, now_[entity]);
}

bool FrameBodies::are_straight(const IndexPair& pair) const {
  return outline_ == Outline::own && goes_straight_[pair.first] && goes_straight_[pair.second] &&
         !group_of_both(scene_, pair.first, pair.second);
}

std::vector<Bounds> FrameBodies::boxes() const {
  std::vector<Bounds> boxes;
  for (std::uint32_t i = 0; i < straight_.size(); ++i) {
    const MovingShape& body = straight_[i];
    if (!goes_straight_[i] || !(doubts_[i] < kTamest)) {  // or is a NaN
      boxes.push_back(box_of(i));
      continue;
    }
    Bounds box = swept(shape_bounds(*body.shape, body.place), body.velocity, 1);
    const Vec2 room(doubts_[i], doubts_[i]);
    if (!box.empty()) box = {box.low - room, box.high + room};
    boxes.push_back(box);
  }
  return boxes;
}

Bounds FrameBodies::box_of(std::uint32_t entity) const {
  Bounds box;
  std::vector<double> times = motion_.knots(entity, std::nullopt, from_, to_);
  times.push_back(to_);
  for (double from = from_; const double to : times) {
    const auto [motion, scale] = motion_.between(entity, std::nullopt, frame_, from, to);
    const bool turns = !motion.angle.is_constant();
    const Bounds around = box_around(motion);
    Bounds still = still_box(*shape(entity), pose({0, 0}, motion.angle.c[0], scale), turns);
    if (still.empty()) return still;
    const Vec2 low = around.low + still.low, high = around.high + still.high;
    const bool tame = low.cwiseAbs().maxCoeff() < kTamest && high.cwiseAbs().maxCoeff() < kTamest;
    if (!tame) return {{-kInfinity, -kInfinity}, {kInfinity, kInfinity}};
    box.add(Bounds{low, high});
    from = to;
  }
  const Vec2 rounding = 0x1p-50 * box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs());
  return {box.low - rounding, box.high + rounding};
}

std::vector<MeetingPart> FrameBodies::meet(const IndexPair& pair) const {
  const auto top = outline_ == Outline::own  // boxes stand upright in the world
                       ? group_of_both(scene_, pair.first, pair.second)
                       : std::nullopt;
  std::vector<MeetingPart> met;
  const auto add = [&](std::vector<MeetingPart> parts) {
    for (MeetingPart& part : parts) {
      if (top) {
        const Pose place = group_poses(scene_, part.times.low)[*top].pose;
        part.point = place(part.point);
        part.normal = unit(place.turned(part.normal));
      }
      met.push_back(part);
    }
  };
  if (top && keeps_velocity_in(scene_, pair.first, *top) &&
      keeps_velocity_in(scene_, pair.second, *top)) {
    const auto body = [&](std::uint32_t entity) {
      return CarriedShape{shape(entity), motion_.between(entity, top, 1, 0, 1)}.as_moving();
    };
    add(shapes_meet(body(pair.first), body(pair.second), {from_, to_}));
    return met;
  }
  std::set<double> times{to_};
  for (const std::uint32_t entity : {pair.first, pair.second})
    for (const double knot : motion_.knots(entity, top, from_, to_)) times.insert(knot);
  for (double from = from_; const double to : times) {
    const auto carried = [&](std::uint32_t entity) {
      return CarriedShape{shape(entity), motion_.between(entity, top, frame_, from, to)};
    };
    std::vector<MeetingPart> parts =
        carried_shapes_meet(carried(pair.first), carried(pair.second), outline_);
    for (MeetingPart& part : parts)
      stretch(part, [&](double t) { return t == 1 ? to : from + t * (to - from); });
    add(std::move(parts));
    from = to;
  }
  return met;
}

void FrameBodies::to_seconds(std::vector<MeetingPart>& parts) const {
  for (MeetingPart& part : parts)
    stretch(part, [&](double t) { return from_ == to_ ? to_ : (frame_ - 1 + t) / scene_.fps; });
}

}  // namespace flatray
