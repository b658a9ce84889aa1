#include "collide/carried_contact.h"

#include <algorithm>

#include "collide/curved_contact.h"
#include "collide/turning_contact.h"

namespace flatray {
namespace {

// Parts as what carries them sees them: of what does not turn as they lie.
struct CarriedParts {
  std::vector<ShapePart> parts;
  RigidMotion motion;

  explicit CarriedParts(const CarriedShape& carried) : motion(carried.way.motion) {
    const bool turns = !motion.angle.is_constant();
    parts =
        parts_of(*carried.shape, pose({0, 0}, turns ? 0 : motion.angle.c[0], carried.way.scale));
    if (!turns) motion.angle = linear(0, 0);
  }

  TurningBody body(const ShapePart& part) const { return {part.ring, part.radius, motion}; }
};

// The first meeting after a time, and when it is over: nothing for the last one, and without any.
// `contact` and `parting` as those of turning bodies, of a range that ends at `length`.
template <class FirstOrLast, class Parting>
std::optional<double> add_carried_part(const FirstOrLast& contact, const Parting& parting,
                                       double from, double length,
                                       std::vector<MeetingPart>& parts) {
  const TurningContact first = contact(false, from);
  if (first.verdict == TurningContact::Verdict::apart) return std::nullopt;
  const bool certain = first.verdict == TurningContact::Verdict::meets;
  const double met = first.first.high;
  const std::optional<double> parted = certain && met < length ? parting(met) : std::nullopt;
  const double last = parted ? *parted : certain ? contact(true, 0.0).first.high : met;
  parts.push_back(proven_part({first.first.low, std::max(met, last)}, first.start, first.place,
                              met - first.first.low, certain));
  return parted;
}

template <class FirstOrLast, class Parting>
void add_carried_parts(const FirstOrLast& contact, const Parting& parting, double length,
                       std::vector<MeetingPart>& parts) {
  for (std::optional<double> from = 0; from && *from < length;)
    from = add_carried_part(contact, parting, *from, length, parts);
}

std::vector<MeetingPart> carried_parts_meet(const CarriedParts& a, const CarriedParts& b,
                                            double length) {
  std::vector<MeetingPart> parts;
  for (const ShapePart& p : a.parts)
    for (const ShapePart& q : b.parts) {
      if (p.curve || q.curve) {
        const auto met = carried_curves_meet(p, a.motion, q, b.motion, length);
        parts.insert(parts.end(), met.begin(), met.end());
        continue;
      }
      const TurningBody one = a.body(p), other = b.body(q);
      add_carried_parts(
          [&](bool backwards, double from) {
            return turning_contact(one, other, length, kTurningWidth, backwards, from);
          },
          [&](double from) { return turning_parting(one, other, from, length, kTurningWidth); },
          length, parts);
    }
  join(parts);
  return parts;
}

// What of a shape has the same upright box around it at every angle it comes to; of what does not
// turn that box.
CarriedParts extents_of(const CarriedShape& carried) {
  CarriedParts extents(carried);
  if (extents.motion.angle.is_constant())
    extents.parts = box_part(
        {carried.shape, pose({0, 0}, carried.way.motion.angle.c[0], carried.way.scale), {0, 0}});
  return extents;
}

std::vector<MeetingPart> carried_boxes_meet(const CarriedShape& a, const CarriedShape& b) {
  const CarriedParts one = extents_of(a), other = extents_of(b);
  std::vector<TurningBody> bodies[2];
  for (const ShapePart& part : one.parts) bodies[0].push_back(one.body(part));
  for (const ShapePart& part : other.parts) bodies[1].push_back(other.body(part));
  std::vector<MeetingPart> parts;
  if (bodies[0].empty() || bodies[1].empty()) return parts;
  add_carried_parts(
      [&](bool backwards, double from) {
        return box_contact(bodies[0], bodies[1], 1, kTurningWidth, backwards, from);
      },
      [&](double from) { return box_parting(bodies[0], bodies[1], from, 1, kTurningWidth); }, 1,
      parts);
  join(parts);
  return parts;
}

bool is_tame(const CarriedShape& carried) {
  const Bounds box = box_around(carried.way.motion);
  return box.low.cwiseAbs().maxCoeff() < kTamest && box.high.cwiseAbs().maxCoeff() < kTamest;
}

}  // namespace

MovingShape CarriedShape::as_moving() const {
  const RigidMotion& motion = way.motion;
  return {shape, pose(motion.at.c[0], motion.angle.c[0], way.scale), motion.at.c[1]};
}

std::vector<MeetingPart> carried_shapes_meet(const CarriedShape& a, const CarriedShape& b,
                                             Outline outline) {
  const auto meet = outline == Outline::own ? shapes_meet : boxes_meet;
  if (a.goes_straight() && b.goes_straight()) return meet(a.as_moving(), b.as_moving(), {0, 1});
  if (!is_tame(a) || !is_tame(b)) return {undecided_part({0, 1})};
  return outline == Outline::own ? carried_parts_meet(CarriedParts(a), CarriedParts(b), 1)
                                 : carried_boxes_meet(a, b);
}

}  // namespace flatray
