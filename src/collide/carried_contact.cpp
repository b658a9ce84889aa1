#include "collide/carried_contact.h"

#include "collide/curved_contact.h"
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
  TurningBody body(const ShapePart& part) const { return {part.ring, part.radius, motion}; }
  TurningParts bodies() const {
    TurningParts all;
    for (const ShapePart& part : parts) all.push_back(body(part));
    return all;
  }
};

// The first meeting after a time of two bodies or of the boxes around their parts.
template <class Body>
struct FirstMeeting {
  const Body &a, &b;  // or what is about them
  TurningContact outer, inner;
  std::optional<double> parted;  // when it is over, if there may be another
  double end = 0;

  // `in_a` and `in_b`: what is in them; nullptr where that is all of them.
  FirstMeeting(const Body& about_a, const Body& about_b, const Body* in_a, const Body* in_b,
               double from)
      : a(about_a), b(about_b), outer(turning_contact(a, b, 1, kTurningWidth, false, from)) {
    if (outer.verdict == Verdict::apart) return;
    inner = in_a ? turning_contact(*in_a, *in_b, 1, kTurningWidth, false, from) : outer;
    const double seen = outer.first.high;
    if (seen < 1) parted = outer.verdict == Verdict::meets ? turning_parting(a, b, seen) : seen;
    end = std::max(seen, parted ? *parted : last(1).first.high);
  }
  TurningContact last(double until) const {
    return turning_contact(a, b, until, kTurningWidth, true);
  }
  std::optional<MeetingPart> part() const {
    if (outer.verdict == Verdict::apart) return std::nullopt;
    const double begin = outer.first.low, met = inner.first.high;
    const bool certain = inner.verdict == Verdict::meets && met <= parted.value_or(1);
    return proven_part({begin, end}, start_between(outer.start, inner.start), outer.place,
                       (certain ? met : end) - begin, certain);
  }
};

// Of bodies as they are.
template <class Body>
void add_meetings(const Body& a, const Body& b, std::vector<MeetingPart>& parts) {
  for (std::optional<double> from = 0; from && *from < 1;) {
    const FirstMeeting<Body> meeting(a, b, nullptr, nullptr, *from);
    if (const auto met = meeting.part()) parts.push_back(*met);
    from = meeting.parted;
  }
}

// Of a normal out of the first of two at a time what the bodies themselves see.
void add_normal(const Vec2& normal, double time, const RigidMotion& a, const RigidMotion& b,
                Normals& normals) {
  for (const bool first : {true, false}) {
    const Turn back = turn(-(first ? a : b).angle(time));
    const Vec2 n = first ? normal : Vec2(-normal);
    normals[first ? 0 : 1].emplace_back(back.cos * n.x() - back.sin * n.y(),
                                        back.sin * n.x() + back.cos * n.y());
  }
}

// Of parts of which one at least is an ellipse: polygons in and about it stand for it.
void add_curved_meetings(const ShapePart& p, const RigidMotion& a, const ShapePart& q,
                         const RigidMotion& b, std::vector<MeetingPart>& parts) {
  Sandwiches layers{Sandwich(p), Sandwich(q)};
  for (std::optional<double> from = 0; from && *from < 1;) {
    std::optional<MeetingPart> met = undecided_part({*from, 1});
    std::optional<double> parted;
    refine(layers, [&] {
      const TurningBody about_a{layers[0].ring(true), p.radius, a},
          about_b{layers[1].ring(true), q.radius, b}, in_a{layers[0].ring(false), p.radius, a},
          in_b{layers[1].ring(false), q.radius, b};
      const FirstMeeting<TurningBody> meeting(about_a, about_b, &in_a, &in_b, *from);
      met = meeting.part();
      parted = meeting.parted;
      Normals normals;
      if (!met) return normals;
      add_normal(meeting.outer.place.normal, met->times.low, a, b, normals);
      const double end = met->times.high;
      add_normal(meeting.last(std::max(end, 0x1p-60)).place.normal, end, a, b, normals);
      return normals;
    });
    if (met) parts.push_back(*met);
    from = parted;
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
    add_meetings(one.bodies(), other.bodies(), parts);
  } else {
    for (const ShapePart& p : one.parts)
      for (const ShapePart& q : other.parts)
        if (p.curve || q.curve)
          add_curved_meetings(p, one.motion, q, other.motion, parts);
        else
          add_meetings(one.body(p), other.body(q), parts);
  }
  join(parts);
  return parts;
}

}  // namespace flatray
