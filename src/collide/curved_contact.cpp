#include <cmath>

#include "collide/outline_contact.h"
#include "collide/sandwich.h"

namespace flatray {
namespace {

struct MovingPart {
  ShapePart part;
  Vec2 velocity;

  MovingBody body(const Sandwich& layers, bool outer) const {
    return {layers.ring(outer), velocity, part.radius};
  }
};

MovingBody back(const MovingBody& body) { return {body.vertices, -body.velocity, body.radius}; }

std::optional<MeetingPart> meeting(const MovingPart& p, const MovingPart& q, Range within) {
  Sandwiches layers{Sandwich(p.part), Sandwich(q.part)};
  std::optional<MeetingPart> met = undecided_part(within);
  refine(layers, [&] {
    const MovingBody a = p.body(layers[0], true), b = q.body(layers[1], true);
    const Contact outer = contact(a, b, within);
    const Contact inner = contact(p.body(layers[0], false), q.body(layers[1], false), within);
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

// Lengths times a power of two: times stay, and squares neither overflow nor are lost. nullopt where that
// is not exact.
std::optional<MovingPart> scaled(MovingPart moving, int exponent) {
  bool is_exact = true;
  const auto scale = [&](double& x) {
    const double there = std::ldexp(x, exponent);
    is_exact = is_exact && std::ldexp(there, -exponent) == x;
    x = there;
  };
  scale(moving.part.radius);
  std::vector<Vec2*> vectors{&moving.velocity};
  for (Vec2& p : moving.part.ring) vectors.push_back(&p);
  if (auto& curve = moving.part.curve)
    vectors.insert(vectors.end(), {&curve->centre, &curve->u, &curve->v});
  for (Vec2* v : vectors) scale(v->x()), scale(v->y());
  return is_exact ? std::optional(std::move(moving)) : std::nullopt;
}

double largest_axis(const ShapePart& part) {
  if (!part.curve) return 0;
  return std::max(part.curve->u.cwiseAbs().maxCoeff(), part.curve->v.cwiseAbs().maxCoeff());
}

}  // namespace

std::optional<MeetingPart> curved_parts_meet(const ShapePart& a, const Vec2& velocity_a,
                                             const ShapePart& b, const Vec2& velocity_b,
                                             Range within) {
  constexpr int kUsual = 400;
  const MovingPart p{a, velocity_a}, q{b, velocity_b};
  const int exponent = -std::ilogb(std::max(largest_axis(a), largest_axis(b)));
  if (std::abs(exponent) <= kUsual) return meeting(p, q, within);
  const auto one = scaled(p, exponent), other = scaled(q, exponent);
  if (!one || !other) return meeting(p, q, within);
  auto met = meeting(*one, *other, within);
  if (met)
    met->point = {std::ldexp(met->point.x(), -exponent), std::ldexp(met->point.y(), -exponent)};
  return met;
}

}  // namespace flatray
