#include "collide/carried_curves.h"

#include <algorithm>

#include "collide/sandwich.h"
#include "collide/turning_contact.h"
#include "geom/turn.h"

namespace flatray {
namespace {

using Verdict = TurningContact::Verdict;

constexpr int kMostRounds = 24;

// Bodies between polygons in and about their curves.
class Curves {
 public:
  Curves(const ShapePart& part_a, const RigidMotion& a, const ShapePart& part_b,
         const RigidMotion& b, double length)
      : layers_{CoreLayers(part_a.ring, part_a.curve), CoreLayers(part_b.ring, part_b.curve)},
        radii_{part_a.radius, part_b.radius},
        motions_{&a, &b},
        length_(length) {}

  // Adds the first meeting after a time; when it is over, if there may be another.
  std::optional<double> add_first(double from, std::vector<MeetingPart>& parts) {
    Pass pass;
    for (int round = 0; round < kMostRounds; ++round) {
      if (!layers_[0].is_sound() || !layers_[1].is_sound()) {
        parts.push_back({{from, length_},
                         HitClass::touch,
                         StartPlace::boundary,
                         {0, 0},
                         {0, 0},
                         length_ - from,
                         false});
        return std::nullopt;
      }
      pass = pass_after(from);
      if (pass.outer.verdict == Verdict::apart) return std::nullopt;
      if (!refine(pass)) break;
    }
    parts.push_back(pass.meeting(length_));
    return pass.parted;
  }

 private:
  struct Pass {
    TurningContact outer, inner;
    std::optional<double> parted;  // for certain, and not to the end
    double last = 0;

    MeetingPart meeting(double length) const {
      const double low = outer.first.low, end = parted.value_or(length);
      const bool certain = inner.verdict == Verdict::meets && inner.first.high <= end;
      const StartPlace start =
          outer.start == StartPlace::inside && inner.start != StartPlace::inside
              ? StartPlace::boundary
              : outer.start;
      return {{low, last},
              certain ? HitClass::through : HitClass::touch,
              start,
              outer.place.point,
              outer.place.normal,
              (certain ? inner.first.high : last) - low,
              certain};
    }
  };

  TurningBody body(int which, bool outer) const {
    const auto i = static_cast<std::size_t>(which);
    const CoreLayers& layers = layers_[i];
    return {outer ? layers.outer() : layers.inner(), radii_[i], *motions_[i]};
  }

  Pass pass_after(double from) const {
    const TurningBody a = body(0, true), b = body(1, true);
    Pass pass;
    pass.outer = turning_contact(a, b, length_, kTurningWidth, false, from);
    if (pass.outer.verdict == Verdict::apart) return pass;
    pass.inner =
        turning_contact(body(0, false), body(1, false), length_, kTurningWidth, false, from);
    const double met = pass.outer.first.high;
    if (pass.outer.verdict == Verdict::undecided)
      pass.parted = met;
    else if (met < length_)
      pass.parted = turning_parting(a, b, met, length_, kTurningWidth);
    if (pass.parted && *pass.parted >= length_) pass.parted.reset();
    pass.last =
        std::max(met, pass.parted ? *pass.parted
                                  : turning_contact(a, b, length_, kTurningWidth, true).first.high);
    return pass;
  }

  // Where the outer polygons first and last touch.
  bool refine(const Pass& pass) {
    const TurningContact last = turning_contact(body(0, true), body(1, true),
                                                std::max(pass.last, 0x1p-60), kTurningWidth, true);
    bool finer = false;
    for (std::size_t i = 0; i < 2; ++i) {
      std::vector<Vec2> normals;
      for (const auto& [contact, time] :
           {std::pair(pass.outer, pass.outer.first.low), std::pair(last, pass.last)}) {
        const Turn back = turn(-motions_[i]->angle(time));
        const Vec2 n = i == 0 ? contact.place.normal : Vec2(-contact.place.normal);
        normals.emplace_back(back.cos * n.x() - back.sin * n.y(),
                             back.sin * n.x() + back.cos * n.y());
      }
      finer |= layers_[i].refine(normals);
    }
    return finer;
  }

  std::array<CoreLayers, 2> layers_;
  const std::array<double, 2> radii_;
  const std::array<const RigidMotion*, 2> motions_;
  const double length_;
};

}  // namespace

std::vector<MeetingPart> carried_curves_meet(const ShapePart& part_a, const RigidMotion& a,
                                             const ShapePart& part_b, const RigidMotion& b,
                                             double length) {
  std::vector<MeetingPart> parts;
  Curves curves(part_a, a, part_b, b, length);
  for (std::optional<double> from = 0; from && *from < length;)
    from = curves.add_first(*from, parts);
  return parts;
}

}  // namespace flatray
