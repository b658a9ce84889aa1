#pragma once
#include <cmath>
#include <vector>

#include "collide/turning_contact.h"

namespace flatray {

// More than bounds are off by, upwards and downwards.
inline constexpr double kUp = 1 + 0x1p-40, kDown = 1 - 0x1p-40;

inline double dot(const Vec2& p, const Vec2& q) { return p.x() * q.x() + p.y() * q.y(); }
inline double length_of(const Vec2& v) { return std::sqrt(dot(v, v)); }

// A body as it is at one time, seen from where the first would be but for its swings.
class TurnedBody {
 public:
  TurnedBody(const TurningBody& body, double scale, double length);

  /// `at` and `moving`: where it would be but for its swings.
  void place(const Vec2& at, const Vec2& moving, double time);

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
