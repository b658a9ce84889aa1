#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/portable_math.h"
#include "collide/minkowski.h"
#include "collide/turning_contact.h"
#include "geom/polygon.h"

namespace flatray {

// More than bounds are off by, upwards and downwards.
inline constexpr double kUp = 1 + 0x1p-40, kDown = 1 - 0x1p-40;

inline double dot(const Vec2& p, const Vec2& q) { return p.x() * q.x() + p.y() * q.y(); }
inline Vec2 turned_by(double c, double s, const Vec2& p) {
  return {c * p.x() - s * p.y(), s * p.x() + c * p.y()};
}

// A body as it is at one time, seen from where the first would be but for its swings.
class TurnedBody {
 public:
  TurnedBody(const TurningBody& body, double scale, double length)
      : radius(scale * body.radius),
        angle(body.motion.angle),
        widest_angle(angle.sum(length)),
        most_spin(angle.most_slope(length)),
        most_turn(angle.most_bend(length)) {
    std::vector<Vec2> ring;
    for (const Vec2& p : body.ring) ring.push_back(scale * p);
    mend_convex(ring);
    for (const std::uint32_t i : turned_ring(ring, ring_orientation(ring)))
      local_.push_back(ring[i]);
    for (std::size_t i = 0; local_.size() > 1 && i < local_.size(); ++i) {
      const Vec2 along = local_[i + 1 == local_.size() ? 0 : i + 1] - local_[i];
      local_normals_.push_back(unit({along.y(), -along.x()}));
    }
    for (const Vec2& p : local_) reach = std::max(reach, kUp * size_of(p));
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

  /// `at` and `moving`: where it would be but for its swings.
  void place(const Vec2& at, const Vec2& moving, double time) {
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
    for (std::size_t i = 0; i < normals.size(); ++i)
      normals[i] = turned_by(c, s, local_normals_[i]);
  }

  Vec2 moves(std::size_t vertex) const {
    return velocity + spin * Vec2(-arms[vertex].y(), arms[vertex].x());
  }
  // How a point would move that turned with the body.
  Vec2 carries(const Vec2& point) const {
    return velocity + spin * Vec2(centre.y() - point.y(), point.x() - centre.x());
  }

  const double radius;
  double reach = 0;  ///< of the core
  Vec2 centre{0, 0}, velocity{0, 0};
  double spin = 0;
  std::vector<Vec2> points, normals, arms;  ///< arms: points from the centre

  const Cubic<double> angle;
  /// At most, at any time: of all its angles; of its spin, and how that changes.
  double widest_angle, most_spin, most_turn;
  /// At most, of what its swings add up to: their size, their speed, and how that changes.
  double swung = 0, swing_speed = 0, swing_bend = 0;

 private:
  std::vector<Swing> swings_;
  std::vector<Vec2> local_, local_normals_;
};

}  // namespace flatray
