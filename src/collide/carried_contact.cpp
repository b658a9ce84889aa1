#include "collide/carried_contact.h"

#include "collide/sandwich.h"
#include "collide/turning_contact.h"
#include "geom/turn.h"

namespace flatray {
namespace {

using Verdict = TurningContact::Verdict;

// Parts as what carries them sees them: of what does not turn as they lie. What of a shape has the same
// upright box around it at every angle it comes to is that box, where it does not turn.
struct CarriedParts {
  std::vector<ShapePart> parts;
  RigidMotion motion;

  CarriedParts(const CarriedShape& carried, Outline outline) : motion(carried.way.motion) {
    const bool turns = !motion.angle.is_constant();
    const Pose place = pose({0, 0}, turns ? 0 : motion.angle.c[0], carried.way.scale);
    parts = parts_of(*carried.shape, place, turns ? Outline::own : outline);
    if (!turns) motion.angle = linear(0, 0);
  }
};

// Two parts; where one is an ellipse, polygons in or about it stand for it.
class PartPair {
 public:
  PartPair(const ShapePart& p, const RigidMotion& a, const ShapePart& q, const RigidMotion& b)
      : layers_{Sandwich(p), Sandwich(q)},
        radii_{p.radius, q.radius},
        motions_{&a, &b},
        is_curved_(p.curve || q.curve) {}

  bool is_curved() const { return is_curved_; }
  Sandwiches& layers() { return layers_; }

  // The first touch from a time on, or the last before one.
  TurningContact first(double from, bool outer) const {
    return turning_contact(body(0, outer), body(1, outer), 1, kTurningWidth, false, from);
  }
  TurningContact last(double until) const {
    return turning_contact(body(0, true), body(1, true), until, kTurningWidth, true);
  }
  std::optional<double> parting(double from) const {
    return turning_parting(body(0, true), body(1, true), from, 1, kTurningWidth);
  }
  // Of a normal out of the first at a time what the bodies themselves see.
  void add_normal(const Vec2& normal, double time, Normals& normals) const {
    for (std::size_t i = 0; i < 2; ++i) {
      const Turn back = turn(-motions_[i]->angle(time));
      const Vec2 n = i == 0 ? normal : Vec2(-normal);
      normals[i].emplace_back(back.cos * n.x() - back.sin * n.y(),
                              back.sin * n.x() + back.cos * n.y());
    }
  }

 private:
  TurningBody body(std::size_t i, bool outer) const {
    return {layers_[i].ring(outer), radii_[i], *motions_[i]};
  }

  Sandwiches layers_;
  const std::array<double, 2> radii_;
  const std::array<const RigidMotion*, 2> motions_;
  const bool is_curved_;
};

// The boxes around all parts of two bodies.
class BoxPair {
 public:
  BoxPair(const CarriedParts& a, const CarriedParts& b) {
    for (const ShapePart& part : a.parts) a_.push_back({part.ring, part.radius, a.motion});
    for (const ShapePart& part : b.parts) b_.push_back({part.ring, part.radius, b.motion});
  }
  TurningContact first(double from, bool) const {
    return box_contact(a_, b_, 1, kTurningWidth, false, from);
  }
  TurningContact last(double until) const {
    return box_contact(a_, b_, until, kTurningWidth, true);
  }
  std::optional<double> parting(double from) const {
    return box_parting(a_, b_, from, 1, kTurningWidth);
  }

 private:
  std::vector<TurningBody> a_, b_;
};

// The first meeting after a time, between that of what is about both and that of what is in them.
struct FirstMeeting {
  TurningContact outer, inner;
  std::optional<double> parted;  // when it is over, if there may be another
  double end = 0;

  template <class Pair>
  FirstMeeting(const Pair& pair, double from, bool is_curved) : outer(pair.first(from, true)) {
    if (outer.verdict == Verdict::apart) return;
    inner = is_curved ? pair.first(from, false) : outer;
    const double seen = outer.first.high;
    if (seen < 1) parted = outer.verdict == Verdict::meets ? pair.parting(seen) : seen;
    end = std::max(seen, parted ? *parted : pair.last(1).first.high);
  }
  std::optional<MeetingPart> part() const {
    if (outer.verdict == Verdict::apart) return std::nullopt;
    const double begin = outer.first.low, met = inner.first.high;
    const bool certain = inner.verdict == Verdict::meets && met <= parted.value_or(1);
    return proven_part({begin, end}, start_between(outer.start, inner.start), outer.place,
                       (certain ? met : end) - begin, certain);
  }
};

void add_meetings(PartPair& pair, std::vector<MeetingPart>& parts) {
  for (std::optional<double> from = 0; from && *from < 1;) {
    std::optional<MeetingPart> met = undecided_part({*from, 1});
    std::optional<double> parted;
    refine(pair.layers(), [&] {
      const FirstMeeting meeting(pair, *from, pair.is_curved());
      met = meeting.part();
      parted = meeting.parted;
      Normals normals;
      if (!met || !pair.is_curved()) return normals;
      pair.add_normal(meeting.outer.place.normal, met->times.low, normals);
      const double end = met->times.high;
      pair.add_normal(pair.last(std::max(end, 0x1p-60)).place.normal, end, normals);
      return normals;
    });
    if (met) parts.push_back(*met);
    from = parted;
  }
}

void add_meetings(const BoxPair& pair, std::vector<MeetingPart>& parts) {
  for (std::optional<double> from = 0; from && *from < 1;) {
    const FirstMeeting meeting(pair, *from, false);
    if (const auto met = meeting.part()) parts.push_back(*met);
    from = meeting.parted;
  }
}

bool is_tame(const CarriedShape& carried) {
  const Bounds box = box_around(carried.way.motion);
  return box.low.cwiseAbs().maxCoeff() < kTamest && box.high.cwiseAbs().maxCoeff() < kTamest;
}

}  // namespace

std::vector<MeetingPart> carried_shapes_meet(const CarriedShape& a, const CarriedShape& b,
                                             Outline outline) {
  if (a.goes_straight() && b.goes_straight())
    return shapes_meet(a.as_moving(), b.as_moving(), {0, 1}, outline);
  if (!is_tame(a) || !is_tame(b)) return {undecided_part({0, 1})};
  const CarriedParts one(a, outline), other(b, outline);
  std::vector<MeetingPart> parts;
  if (one.parts.empty() || other.parts.empty()) return parts;
  if (outline == Outline::box) {
    add_meetings(BoxPair(one, other), parts);
  } else {
    for (const ShapePart& p : one.parts)
      for (const ShapePart& q : other.parts) {
        PartPair pair(p, one.motion, q, other.motion);
        add_meetings(pair, parts);
      }
  }
  join(parts);
  return parts;
}

}  // namespace flatray
