#pragma once
#include <cmath>
#include <optional>

#include "geom/ray.h"

namespace flatray {

/// What a change of the index of refraction does to light, or to an orbit.
struct Refraction {
  double ratio, cosine;  ///< as given
  double beyond;         ///< cosine between the normal and what goes on
  double reflected;      ///< part of the energy, of unpolarised light: half of either polarisation

  /// Where `direction` goes on, of length 1. Needs   both of length 1, `normal` towards where it comes from.
  Vec2 of(const Vec2& direction, const Vec2& normal) const {
    const Vec2 out = ratio * direction + (ratio * cosine - beyond) * normal;
    return out / std::sqrt(out.dot(out));
  }
  /// How much wider a thin pencil is beyond.
  double widening() const { return beyond / cosine; }
};

/// Snell's law and Fresnel's equations; nullopt: all is reflected.
///
/// Needs   `ratio` of the index it comes from to the other, above 0; the cosine of its incidence, above 0.
/// Error   some ulps of (ratio cosine)^2 and of |1 - ratio^2| in the square of `beyond`. Where they decide, near the
///         critical angle, it is near 0 and next to all is reflected either way.
inline std::optional<Refraction> refraction(double ratio, double cosine) {
  const double square = (1 - ratio) * (1 + ratio) + ratio * cosine * (ratio * cosine);  // of beyond
  if (!(square > 0)) return std::nullopt;
  const double beyond = std::sqrt(square);
  const double s = (ratio * cosine - beyond) / (ratio * cosine + beyond);
  const double p = (ratio * beyond - cosine) / (ratio * beyond + cosine);
  return Refraction{ratio, cosine, beyond, (s * s + p * p) / 2};
}

}  // namespace flatray
