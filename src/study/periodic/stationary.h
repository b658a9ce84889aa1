#pragma once
#include <vector>

#include "study/periodic/mirrors.h"

namespace flatray {

/// A bounce off a curved wall in a closed orbit, near the direction `at` in the coordinates in
/// which the wall's curve is the unit circle. What comes between it and the next such bounce,
/// reflections by straight walls, is unfolded: there the next one is at `next` of its place.
struct CurvedBounce {
  const Arc* arc;
  Vec2 at{1, 0};
  Isometry<Near> next{};
  std::size_t place = 0;  ///< in the word
};

/// A point of a curve, and its derivatives by q. The curve's points are centre + U (1 - q^2) / (1 +
/// q^2) + V 2 q / (1 + q^2) with U toward `at`: no sine is needed, and only the point opposite is
/// left out.
struct CurvePlace {
  Pair<Near> point, rate, bend;
};
CurvePlace curve_place(const CurvedBounce& bounce, const Near& q);

/// The bounces of a closed orbit off curved walls: places at which the length of the closed
/// polygon, unfolded, is stationary. A single one has itself as the next.
class StationaryPolygon {
 public:
  explicit StationaryPolygon(std::vector<CurvedBounce> bounces) : bounces_(std::move(bounces)) {}

  /// Newton's method in plain doubles, from where they are. Gives   whether it has come to a stop.
  bool improve();

  /// Proof by Krawczyk's operator that within certain distances q of where the bounces are, and
  /// there alone, is one solution. Rounding of coordinates is counted for; they are taken as given.
  ///
  /// Gives   whether that has been proven; `places` are then enclosures.
  /// Source  R. Krawczyk (1969); S. M. Rump, Verification methods (2010), section 13.
  bool prove();

  /// Takes places within a box of q about where the bounces are. Gives   false where the length is
  /// proven not to be stationary anywhere in it.
  bool may_be_within(const std::vector<Near>& box);

  const std::vector<CurvedBounce>& bounces() const { return bounces_; }
  std::vector<CurvedBounce>& bounces() { return bounces_; }
  CurvePlace place(std::size_t i) const { return curve_place(bounces_[i], places_[i]); }
  std::size_t after(std::size_t i) const { return i + 1 < bounces_.size() ? i + 1 : 0; }
  /// From a bounce to the next, unfolded.
  Pair<Near> way_from(std::size_t i) const {
    return bounces_[i].next(place(after(i)).point) - place(i).point;
  }
  /// The way on which it comes to a bounce.
  Pair<Near> way_to(std::size_t i) const {
    const std::size_t before = i > 0 ? i - 1 : bounces_.size() - 1;
    const auto way = way_from(before);
    const Isometry<Near>& unfolded = bounces_[before].next;
    return {dot(unfolded.x, way), dot(unfolded.y, way)};
  }

 private:
  std::vector<CurvedBounce> bounces_;
  std::vector<Near> places_;
};

/// The length of a vector; an unknown where it may be 0.
inline Near length_of(const Pair<Near>& v) { return square_root(dot(v, v)); }

}  // namespace flatray
