#include "collide/sandwich.h"

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

}  // namespace flatray
