#pragma once
#include "scene/keys/curve_keys.h"
#include "scene/keys/keys.h"

namespace flatray {

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
inline constexpr Key<T> kVelocityKey = {{"velocity", "[vx, vy]", "[0, 0]"}, &set<&T::velocity, T>};
template <class T>
inline constexpr Key<T> kAngularVelocityKey = {{"angular_velocity", "degrees a second", "0"},
                                               &set_angle<&T::angular_velocity, T>};
template <class T>
inline constexpr Key<T> kFollowKey = {{"follow", "{ path = [[x, y], ...], speed = v }", "none"},
                                      &set_follow<T>};

std::vector<TableInfo> motion_tables();

}  // namespace flatray
