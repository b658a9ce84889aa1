#include "collide/sandwich.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "base/portable_math.h"
#include "geom/predicates.h"

namespace flatray {
namespace {

constexpr double kWhole = 2 * std::numbers::pi;
constexpr int kFirstCorners = 16, kFiner = 4;
// More than a corner is rounded by, as a part of what it adds up.
constexpr double kRounding = 0x1p-45;

// Whether a ring turns one way only.
bool is_convex(std::span<const Vec2> ring) {
  const std::size_t n = ring.size();
  Sign sense = Sign::zero;
  for (std::size_t i = 0; n > 2 && i < n; ++i) {
    const Sign turn = orientation(ring[i], ring[(i + 1) % n], ring[(i + 2) % n]);
    if (turn == Sign::zero || (sense != Sign::zero && turn != sense)) return false;
    sense = turn;
  }
  return true;
}

}  // namespace

Sandwich::Sandwich(const Ellipse& curve) : curve_(curve), width_(kWhole / kFirstCorners) {
  const double long_axis = std::sqrt(curve.u.squaredNorm() + curve.v.squaredNorm());
  const double short_axis = std::fabs(cross(curve.u, curve.v)) / long_axis;
  const double rounding =
      kRounding * (curve.centre.lpNorm<1>() + curve.u.lpNorm<1>() + curve.v.lpNorm<1>());
  room_ = rounding / short_axis;
  finest_ = 8 * std::sqrt(room_);
  for (int i = 0; i < kFirstCorners; ++i) angles_.push_back(kWhole * i / kFirstCorners);
}

Sandwich::Ring Sandwich::inner() const {
  Ring ring;
  for (const double angle : angles_) ring.push_back(corner(angle, 1 - room_));
  return ring;
}

Sandwich::Ring Sandwich::outer() const {
  Ring ring;
  for (std::size_t i = 0; i < angles_.size(); ++i) {
    const double from = angles_[i],
                 to = i + 1 < angles_.size() ? angles_[i + 1] : angles_[0] + kWhole;
    ring.push_back(corner(0.5 * (from + to), (1 + room_) / portable::cos(0.5 * (to - from))));
  }
  return ring;
}

bool Sandwich::refine(const std::vector<Vec2>& directions) {
  if (!(width_ / kFiner > finest_) || directions.empty()) return false;
  for (const Vec2& n : directions) {
    const double middle = portable::atan2(n.dot(curve_.v), n.dot(curve_.u));
    for (int i = -2 * kFiner; i <= 2 * kFiner; ++i) add(middle + i * width_ / kFiner);
  }
  width_ /= kFiner;
  std::sort(angles_.begin(), angles_.end());
  return true;
}

Vec2 Sandwich::corner(double angle, double scale) const {
  return curve_.centre +
         scale * (portable::cos(angle) * curve_.u + portable::sin(angle) * curve_.v);
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

CoreLayers::CoreLayers(std::span<const Vec2> core, const std::optional<Ellipse>& curve)
    : core_(core) {
  if (!curve) return;
  curve_.emplace(*curve);
  make_rings();
}

bool CoreLayers::refine(const std::vector<Vec2>& directions) {
  if (!curve_ || !curve_->refine(directions)) return false;
  make_rings();
  return true;
}

void CoreLayers::make_rings() {
  sound_ = curve_->is_sound();
  if (!sound_) return;
  inner_ = curve_->inner();
  outer_ = curve_->outer();
  sound_ = is_convex(inner_) && is_convex(outer_);
}

}  // namespace flatray
