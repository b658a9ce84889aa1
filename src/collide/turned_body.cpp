#include "collide/turned_body.h"

#include <algorithm>

#include "base/portable_math.h"
#include "collide/minkowski.h"
#include "geom/polygon.h"

namespace flatray {
namespace {

Vec2 turned_by(double c, double s, const Vec2& p) {
  return {c * p.x() - s * p.y(), s * p.x() + c * p.y()};
}

}  // namespace

TurnedBody::TurnedBody(const TurningBody& body, double scale, double length)
    : radius(scale * body.radius),
      angle(body.motion.angle),
      widest_angle(angle.sum(length)),
      most_spin(angle.most_slope(length)),
      most_turn(angle.most_bend(length)) {
  for (const std::uint32_t i : turned_ring(body.ring, ring_orientation(body.ring)))
    local_.push_back(scale * body.ring[i]);
  for (std::size_t i = 0; local_.size() > 1 && i < local_.size(); ++i) {
    const Vec2 along = local_[i + 1 == local_.size() ? 0 : i + 1] - local_[i];
    local_normals_.push_back(Vec2(along.y(), -along.x()).stableNormalized());
  }
  for (const Vec2& p : local_) reach = std::max(reach, kUp * length_of(p));
  arms.resize(local_.size());
  points.resize(local_.size());
  normals.resize(local_normals_.size());
  for (const Swing& swing : body.motion.swings) {
    swings_.push_back({scale * swing.arm, swing.turned});
    const Cubic<Vec2>& arm = swings_.back().arm;
    const double spins = swing.turned.most_slope(length), turns = swing.turned.most_bend(length);
    const double size = arm.sum(length), speed = arm.sum_of_slope(length);
    widest_angle = std::max(widest_angle, swing.turned.sum(length));
    swung += kUp * size;
    swing_speed += kUp * (speed + spins * size);
    swing_bend +=
        kUp * (arm.most_bend(length) + 2 * spins * speed + (spins * spins + turns) * size);
  }
}

void TurnedBody::place(const Vec2& at, const Vec2& moving, double time) {
  centre = at;
  velocity = moving;
  for (const Swing& swing : swings_) {
    const double by = swing.turned(time), pace = swing.turned.slope(time);
    const double c = portable::cos(by), s = portable::sin(by);
    const Vec2 arm = turned_by(c, s, swing.arm(time));
    centre += arm;
    velocity += turned_by(c, s, swing.arm.slope(time)) + pace * Vec2(-arm.y(), arm.x());
  }
  spin = angle.slope(time);
  const double now = angle(time), c = portable::cos(now), s = portable::sin(now);
  for (std::size_t i = 0; i < local_.size(); ++i) {
    arms[i] = turned_by(c, s, local_[i]);
    points[i] = centre + arms[i];
  }
  for (std::size_t i = 0; i < normals.size(); ++i) normals[i] = turned_by(c, s, local_normals_[i]);
}

}  // namespace flatray
