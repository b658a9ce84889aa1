#include "collide/outline_contact.h"

#include <algorithm>

namespace flatray {
namespace {

using Ring = std::vector<Vec2>;

MeetingPart meeting_part(const RoundContact& met, const RoundBody& a, const RoundBody& b) {
  const HitInterval& times = met.times;
  MeetingPart part{{times.t_enter, times.t_exit}, times.kind, times.start, {0, 0}, {0, 0}};
  const RoundPlace place =
      met.first ? place_at(*met.first, a, b, times.t_enter) : resting_place(a, b, part.times.low);
  part.point = place.point;
  part.normal = place.normal;
  return part;
}

void join(std::vector<MeetingPart>& parts) {
  std::sort(parts.begin(), parts.end(),
            [](const MeetingPart& p, const MeetingPart& q) { return p.times.low < q.times.low; });
  std::size_t kept = 0;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    MeetingPart& last = parts[kept];
    if (parts[i].times.low > last.times.high) {
      parts[++kept] = parts[i];
      continue;
    }
    last.times.high = std::max(last.times.high, parts[i].times.high);
    last.kind = std::max(last.kind, parts[i].kind);
    last.start = std::max(last.start, parts[i].start);
  }
  if (!parts.empty()) parts.resize(kept + 1);
}

std::vector<MeetingPart> parts_meet(const std::vector<ShapePart>& parts_a, const Vec2& velocity_a,
                                    const std::vector<ShapePart>& parts_b, const Vec2& velocity_b,
                                    Range within) {
  std::vector<MeetingPart> parts;
  for (const ShapePart& p : parts_a)
    for (const ShapePart& q : parts_b) {
      const RoundBody one{{p.ring, velocity_a}, p.radius}, other{{q.ring, velocity_b}, q.radius};
      const RoundContact met = round_contact(one, other, within);
      if (met.times) parts.push_back(meeting_part(met, one, other));
    }
  join(parts);
  return parts;
}

std::vector<ShapePart> box_of(const MovingShape& moving) {
  const Bounds box = shape_bounds(*moving.shape, moving.place);
  if (box.empty()) return {};
  return {{{box.low, {box.high.x(), box.low.y()}, box.high, {box.low.x(), box.high.y()}}}};
}

}  // namespace

std::vector<ShapePart> parts_of(const Shape& shape, const Pose& place) {
  std::vector<ShapePart> all;
  for (std::size_t i = 0; i < shape.piece_count(); ++i)
    all.push_back({posed_piece(shape, i, place)});
  for (const Segment& s : shape.segments) all.push_back({{place(s.a), place(s.b)}});
  for (const Circle& c : shape.circles) {
    const Circle there = posed(c, place);
    all.push_back({{there.centre}, there.radius});
  }
  return all;
}

std::vector<MeetingPart> shapes_meet(const MovingShape& a, const MovingShape& b, Range within) {
  return parts_meet(parts_of(*a.shape, a.place), a.velocity, parts_of(*b.shape, b.place),
                    b.velocity, within);
}

std::vector<MeetingPart> boxes_meet(const MovingShape& a, const MovingShape& b, Range within) {
  return parts_meet(box_of(a), a.velocity, box_of(b), b.velocity, within);
}

bool has_parts_left_out(const Shape& shape) {
  return !shape.arc_paths.empty() || !shape.crossing_rings.empty();
}

}  // namespace flatray
