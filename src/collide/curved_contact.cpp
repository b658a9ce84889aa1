#include "collide/curved_contact.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "collide/sandwich.h"
#include "collide/turning_contact.h"
#include "geom/turn.h"

namespace flatray {
namespace {

using Verdict = TurningContact::Verdict;
using Normals = std::array<std::vector<Vec2>, 2>;  // out of each of two bodies

constexpr int kMostRounds = 24;

// Two bodies between polygons in and about their curves.
class Layers {
 public:
  Layers(const ShapePart& a, const ShapePart& b)
      : layers_{CoreLayers(a.ring, a.curve), CoreLayers(b.ring, b.curve)},
        radii_{a.radius, b.radius} {}

  std::span<const Vec2> core(std::size_t body, bool outer) const {
    return outer ? layers_[body].outer() : layers_[body].inner();
  }
  double radius(std::size_t body) const { return radii_[body]; }

  // Calls `look()` for what is known; it gives the normals along which more is to be known.
  template <class Look>
  void refine(const Look& look) {
    for (int round = 0; round < kMostRounds; ++round) {
      if (!layers_[0].is_sound() || !layers_[1].is_sound()) return;
      const Normals normals = look();
      const bool finer_a = layers_[0].refine(normals[0]), finer_b = layers_[1].refine(normals[1]);
      if (!finer_a && !finer_b) return;
    }
  }

 private:
  std::array<CoreLayers, 2> layers_;
  std::array<double, 2> radii_;
};

// How bodies lie that are between outer and inner ones.
StartPlace start_between(StartPlace outer, StartPlace inner) {
  return inner == StartPlace::inside    ? StartPlace::inside
         : outer == StartPlace::outside ? StartPlace::outside
                                        : StartPlace::boundary;
}

MovingBody back(const MovingBody& body) { return {body.vertices, -body.velocity, body.radius}; }

std::optional<MeetingPart> straight_meeting(const ShapePart& p, const Vec2& velocity_p,
                                            const ShapePart& q, const Vec2& velocity_q,
                                            Range within) {
  Layers layers(p, q);
  std::optional<MeetingPart> met = undecided_part(within);
  layers.refine([&] {
    const auto pair = [&](bool outer) {
      return std::pair(MovingBody{layers.core(0, outer), velocity_p, layers.radius(0)},
                       MovingBody{layers.core(1, outer), velocity_q, layers.radius(1)});
    };
    const auto [a, b] = pair(true);
    const auto [inner_a, inner_b] = pair(false);
    const Contact outer = contact(a, b, within), inner = contact(inner_a, inner_b, within);
    const HitInterval &out = outer.times, &in = inner.times;
    Normals normals;
    met.reset();
    if (!out) return normals;
    const double latest = in ? std::max(in.t_enter, out.t_enter) : out.t_exit;
    met = proven_part({out.t_enter, out.t_exit}, start_between(out.start, in.start),
                      first_place(outer, a, b), latest - out.t_enter, bool(in));
    const auto add = [&](const Vec2& normal) {
      normals[0].push_back(normal);
      normals[1].push_back(-normal);
    };
    if (outer.first) add(contact_place(outer.first, a, b, out.t_enter).normal);
    // Where they part is where they would meet with the time run backwards.
    if (outer.last) add(contact_place(outer.last, back(a), back(b), -out.t_exit).normal);
    return normals;
  });
  return met;
}

// Lengths times a power of two, as far as that is exact: times stay, and squares neither overflow nor
// are lost.
class Scaling {
 public:
  explicit Scaling(int exponent) : exponent_(exponent) {}

  bool is_exact() const { return is_exact_; }
  double operator()(double x) {
    const double there = std::ldexp(x, exponent_);
    is_exact_ = is_exact_ && std::ldexp(there, -exponent_) == x;
    return there;
  }
  Vec2 operator()(const Vec2& v) { return {(*this)(v.x()), (*this)(v.y())}; }
  ShapePart operator()(ShapePart part) {
    for (Vec2& p : part.ring) p = (*this)(p);
    part.radius = (*this)(part.radius);
    if (part.curve)
      for (Vec2* v : {&part.curve->centre, &part.curve->u, &part.curve->v}) *v = (*this)(*v);
    return part;
  }

 private:
  const int exponent_;
  bool is_exact_ = true;
};

double largest_axis(const ShapePart& part) {
  if (!part.curve) return 0;
  return std::max(part.curve->u.cwiseAbs().maxCoeff(), part.curve->v.cwiseAbs().maxCoeff());
}

// Bodies that are carried along.
class CarriedCurves {
 public:
  CarriedCurves(const ShapePart& part_a, const RigidMotion& a, const ShapePart& part_b,
                const RigidMotion& b, double length)
      : layers_(part_a, part_b), motions_{&a, &b}, length_(length) {}

  // Adds the first meeting after a time; when it is over, if there may be another.
  std::optional<double> add_first(double from, std::vector<MeetingPart>& parts) {
    std::optional<MeetingPart> met = undecided_part({from, length_});
    std::optional<double> parted;
    layers_.refine([&] { return look(from, met, parted); });
    if (met) parts.push_back(*met);
    return parted;
  }

 private:
  TurningBody body(std::size_t i, bool outer) const {
    return {layers_.core(i, outer), layers_.radius(i), *motions_[i]};
  }
  TurningContact contact_of(bool outer, double from) const {
    return turning_contact(body(0, outer), body(1, outer), length_, kTurningWidth, false, from);
  }
  // The last before a time.
  TurningContact last_before(double time) const {
    return turning_contact(body(0, true), body(1, true), time, kTurningWidth, true);
  }

  Normals look(double from, std::optional<MeetingPart>& met, std::optional<double>& parted) const {
    met.reset();
    parted.reset();
    const TurningContact outer = contact_of(true, from);
    if (outer.verdict == Verdict::apart) return {};
    const TurningContact inner = contact_of(false, from);
    const double first = outer.first.low, seen = outer.first.high;
    if (outer.verdict == Verdict::undecided)
      parted = seen;
    else if (seen < length_)
      parted = turning_parting(body(0, true), body(1, true), seen, length_, kTurningWidth);
    if (parted && *parted >= length_) parted.reset();
    const double last = std::max(seen, parted ? *parted : last_before(length_).first.high);
    const bool certain =
        inner.verdict == Verdict::meets && inner.first.high <= parted.value_or(length_);
    met = proven_part({first, last}, start_between(outer.start, inner.start), outer.place,
                      (certain ? inner.first.high : last) - first, certain);
    Normals normals;
    add_normal(outer.place.normal, first, normals);
    add_normal(last_before(std::max(last, 0x1p-60)).place.normal, last, normals);
    return normals;
  }

  // As the bodies themselves see it.
  void add_normal(const Vec2& normal, double time, Normals& normals) const {
    for (std::size_t i = 0; i < 2; ++i) {
      const Turn back = turn(-motions_[i]->angle(time));
      const Vec2 n = i == 0 ? normal : Vec2(-normal);
      normals[i].emplace_back(back.cos * n.x() - back.sin * n.y(),
                              back.sin * n.x() + back.cos * n.y());
    }
  }

  Layers layers_;
  const std::array<const RigidMotion*, 2> motions_;
  const double length_;
};

}  // namespace

std::optional<MeetingPart> curved_parts_meet(const ShapePart& a, const Vec2& velocity_a,
                                             const ShapePart& b, const Vec2& velocity_b,
                                             Range within) {
  constexpr int kUsual = 400;
  const int exponent = -std::ilogb(std::max(largest_axis(a), largest_axis(b)));
  if (std::abs(exponent) > kUsual) {
    Scaling scaled(exponent);
    const ShapePart one = scaled(a), other = scaled(b);
    const Vec2 velocity_one = scaled(velocity_a), velocity_other = scaled(velocity_b);
    if (scaled.is_exact()) {
      auto met = straight_meeting(one, velocity_one, other, velocity_other, within);
      if (met) met->point = Scaling(-exponent)(met->point);
      return met;
    }
  }
  return straight_meeting(a, velocity_a, b, velocity_b, within);
}

std::vector<MeetingPart> carried_curves_meet(const ShapePart& part_a, const RigidMotion& a,
                                             const ShapePart& part_b, const RigidMotion& b,
                                             double length) {
  std::vector<MeetingPart> parts;
  CarriedCurves curves(part_a, a, part_b, b, length);
  for (std::optional<double> from = 0; from && *from < length;)
    from = curves.add_first(*from, parts);
  return parts;
}

}  // namespace flatray
