#pragma once
#include "collide/contact.h"

namespace flatray {

/// Where two bodies touch, and the unit normal there, out of the first; about.
struct ContactPlace {
  Vec2 point, normal;
};

/// Where bodies meet that come to touch at t, by what of them does.
ContactPlace contact_place(const ContactFeature& feature, const MovingBody& a, const MovingBody& b,
                           double t);

/// Where bodies touch or overlap at a time, whatever way they came: the normal of the shortest way
/// apart, about; 0 for two points that coincide.
ContactPlace resting_place(const MovingBody& a, const MovingBody& b, double t);

/// That of a contact at t_enter, by the one or the other.
ContactPlace first_place(const Contact& met, const MovingBody& a, const MovingBody& b);

}  // namespace flatray
