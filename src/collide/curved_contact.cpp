#include "collide/curved_contact.h"

#include <cmath>
#include <numbers>

#include "base/portable_math.h"
#include "geom/predicates.h"

namespace flatray {
namespace {

constexpr double kWhole = 2 * std::numbers::pi;
constexpr int kFirstCorners = 16, kFiner = 4;
// More than a corner is rounded by, as a part of what it adds up.
constexpr double kRounding = 0x1p-45;

// Whether a ring turns one way only.
bool is_convex(const Sandwich::Ring& ring) {
  const std::size_t n = ring.size();
  Sign sense = Sign::zero;
  for (std::size_t i = 0; n > 2 && i < n; ++i) {
    const Sign turn = orientation(ring[i], ring[(i + 1) % n], ring[(i + 2) % n]);
    if (turn == Sign::zero || (sense != Sign::zero && turn != sense)) return false;
    sense = turn;
  }
  return true;
}

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

Sandwich::Sandwich(const ShapePart& part) : part_(part), width_(kWhole / kFirstCorners) {
  if (!part.curve) return;
  const auto& [centre, u, v] = *part.curve;
  const double long_axis = std::sqrt(u.squaredNorm() + v.squaredNorm());
  const double short_axis = std::fabs(cross(u, v)) / long_axis;
  room_ = kRounding * (centre.lpNorm<1>() + u.lpNorm<1>() + v.lpNorm<1>()) / short_axis;
  finest_ = 8 * std::sqrt(room_);
  for (int i = 0; i < kFirstCorners; ++i) angles_.push_back(kWhole * i / kFirstCorners);
  make_rings();
}

bool Sandwich::refine(const std::vector<Vec2>& directions) {
  if (!part_.curve || !(width_ / kFiner > finest_) || directions.empty()) return false;
  for (const Vec2& n : directions) {
    const double middle = portable::atan2(n.dot(part_.curve->v), n.dot(part_.curve->u));
    for (int i = -2 * kFiner; i <= 2 * kFiner; ++i) add(middle + i * width_ / kFiner);
  }
  width_ /= kFiner;
  std::sort(angles_.begin(), angles_.end());
  make_rings();
  return true;
}

Vec2 Sandwich::corner(double angle, double scale) const {
  const auto& [centre, u, v] = *part_.curve;
  return centre + scale * (portable::cos(angle) * u + portable::sin(angle) * v);
}

// Not too near another, so that rounding leaves the polygon convex.
void Sandwich::add(double angle) {
  if (angle < 0) angle += kWhole;
  if (angle >= kWhole) angle -= kWhole;
  for (const double other : angles_) {
    const double apart = std::fabs(angle - other);
    if (std::min(apart, kWhole - apart) < width_ / (2 * kFiner)) return;
  }
  angles_.push_back(angle);
}

void Sandwich::make_rings() {
  sound_ = room_ < 0x1p-10;  // rounding leaves something of it
  if (!sound_) return;
  inner_.clear();
  outer_.clear();
  for (std::size_t i = 0; i < angles_.size(); ++i) {
    const double from = angles_[i];
    const double to = i + 1 < angles_.size() ? angles_[i + 1] : angles_[0] + kWhole;
    inner_.push_back(corner(from, 1 - room_));
    outer_.push_back(corner(0.5 * (from + to), (1 + room_) / portable::cos(0.5 * (to - from))));
  }
  sound_ = is_convex(inner_) && is_convex(outer_);
}

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
