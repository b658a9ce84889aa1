#pragma once
#include <cmath>

#include "base/portable_math.h"
#include "geom/refract.h"
#include "transport/orbit.h"

namespace flatray {

/// How two orbits an infinitesimal way apart part, across the ray: apart by q, at an angle p. A
/// flight of length t adds t p to q; a mirror of curvature k adds 2 k q / cos(incidence) to p and
/// turns both round. In a magnetic field, of flights of curvature b, q'' = -b^2 q; and as the
/// neighbour comes to the mirror q tan(incidence) later and flies off it as much earlier, its
/// direction turns by b for each.
///
/// Glass keeps q / cos along the wall, and the index times the cosine times the angle to its
/// normal, which turns by the curvature: q p times the index is kept, Snell's law differentiated.
///
/// Units   any: lengths, curvatures and fields of one.
/// Source  Sinai 1970; Berglund and Kunz 1996 for the field.
struct Tangent {
  double q = 1, p = 1;

  void fly(double t) { q += t * p; }
  void fly(double t, double field) {
    const double c = portable::cos(field * t), s = portable::sin(field * t), before = q;
    q = c * q + s / field * p;
    p = c * p - s * field * before;
  }
  void reflect(double bend) {
    p = -(p + bend * q);
    q = -q;
  }
  /// Glass of a curvature as the mirror's, over the cosine of the incidence.
  void refract(const Refraction& met, double curvature) {
    const double turn = curvature / met.cosine * q, narrowing = met.ratio / met.widening();
    p = narrowing * (p + turn) - turn;
    q *= met.widening();
  }
  /// Brings its length back to 1; gives the logarithm of what it was.
  double restore() {
    const double size = std::sqrt(q * q + p * p);
    q /= size;
    p /= size;
    return portable::log(size);
  }
};

/// What reflect() takes of a mirror of a curvature (study/rooms/wall_places.h) in a field.
inline double bend_in_field(const Bounce& bounce, double curvature, double field) {
  const double speed = std::sqrt(bounce.in.squaredNorm());
  const double sine = cross(bounce.normal, bounce.in) / speed;
  return 2 * (curvature - field * sine) / (std::fabs(bounce.in.dot(bounce.normal)) / speed);
}

}  // namespace flatray
