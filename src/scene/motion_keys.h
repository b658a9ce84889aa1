#pragma once
#include "scene/keys.h"

namespace flatray {

/// A number that may be a curve: its value, or 0 and the curve.
struct Moving {
  double value = 0;
  std::optional<CurveId> curve;
};
/// What is read is handed to `change` first, a function of double that may change units.
std::optional<Moving> read_moving(Builder& builder, const Field& field,
                                  double (*change)(double) = nullptr);

/// Smallest and largest value of a curve.
double lowest(const Curve& curve);
double highest(const Curve& curve);

/// A point that may be a curve, or have curves as coordinates: added to where `at` leaves them.
struct MovingPoint {
  Vec2 value{0, 0};
  std::optional<CurveId> x, y;
};
std::optional<MovingPoint> read_moving_point(Builder& builder, const Field& field);

void read_follow_path(Builder& builder, const Field& field, Motion& motion);

/// Keys of what moves: entities and groups.
template <class T>
void set_moving_at(Builder& builder, const Field& field, T& thing) {
  const std::optional<MovingPoint> at = read_moving_point(builder, field);
  if (!at) return;
  thing.at = at->value;
  thing.motion.x = at->x;
  thing.motion.y = at->y;
}
template <class T>
void set_moving_angle(Builder& builder, const Field& field, T& thing) {
  const std::optional<Moving> angle = read_moving(builder, field, &radians);
  if (!angle) return;
  thing.angle = angle->value;
  thing.motion.angle = angle->curve;
}
template <class T>
void set_follow(Builder& builder, const Field& field, T& thing) {
  read_follow_path(builder, field, thing.motion);
}
template <class T>
inline constexpr Key<T> kMovingAtKey = {{"at", "[x, y] or a curve", "[0, 0]"}, &set_moving_at<T>};
template <class T>
inline constexpr Key<T> kMovingAngleKey = {{"angle", "degrees or a curve", "0"},
                                           &set_moving_angle<T>};
template <class T>
inline constexpr Key<T> kFollowKey = {{"follow", "{ path = [[x, y], ...], speed = v }", "none"},
                                      &set_follow<T>};

std::vector<TableInfo> motion_tables();

}  // namespace flatray
