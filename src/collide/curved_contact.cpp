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
// Units are up to 2^1000; more than the least doubles are then.
constexpr int kMostUnit = 1000;
constexpr double kLeast = 0x1p-70;

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

MovingBody back(const MovingBody& body) { return {body.vertices, -body.velocity, body.radius}; }

}  // namespace

Sandwich::Sandwich(const ShapePart& part) : part_(part), width_(kWhole / kFirstCorners) {
  if (!part.curve) return;
  // In a unit, a power of two, in which squares neither overflow nor are lost.
  const double most =
      std::max(part.curve->u.cwiseAbs().maxCoeff(), part.curve->v.cwiseAbs().maxCoeff());
  const double unit = std::ldexp(1.0, -std::clamp(std::ilogb(most), -kMostUnit, kMostUnit));
  const Vec2 centre = unit * part.curve->centre, u = unit * part.curve->u, v = unit * part.curve->v;
  const double long_axis = std::sqrt(u.squaredNorm() + v.squaredNorm());
  const double short_axis = std::fabs(cross(u, v)) / long_axis;
  const double size = centre.lpNorm<1>() + u.lpNorm<1>() + v.lpNorm<1>();
  room_ = std::max(kRounding * size, kLeast) / short_axis;
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
  std::ranges::sort(angles_);
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

std::optional<MeetingPart> curved_parts_meet(const ShapePart& p, const Vec2& velocity_p,
                                             const ShapePart& q, const Vec2& velocity_q,
                                             Range within) {
  Sandwiches layers{Sandwich(p), Sandwich(q)};
  std::optional<MeetingPart> met = undecided_part(within);
  refine(layers, [&] {
    const auto body_p = [&](bool outer) -> MovingBody {
      return {layers[0].ring(outer), velocity_p, p.radius};
    };
    const auto body_q = [&](bool outer) -> MovingBody {
      return {layers[1].ring(outer), velocity_q, q.radius};
    };
    const MovingBody a = body_p(true), b = body_q(true);
    const Contact outer = contact(a, b, within);
    const Contact inner = contact(body_p(false), body_q(false), within);
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

}  // namespace flatray
