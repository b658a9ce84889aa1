#pragma once
#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "collide/outline_contact.h"

namespace flatray {

/// Polygons in and about a part of a body: its core, or of an ellipse such as touch it at chosen angles of
/// u and v: made finer where that matters. Proofs: docs/NUMERICS.md.
class Sandwich {
 public:
  using Ring = std::vector<Vec2>;

  /// Needs   a finite ellipse with an area, if any; the part outlives it.
  explicit Sandwich(const ShapePart& part);

  std::span<const Vec2> ring(bool outer) const {
    return !part_.curve ? part_.ring : outer ? outer_ : inner_;
  }
  /// Whether the polygons are what they should be, in spite of rounding.
  bool is_sound() const { return sound_; }
  /// More corners where an ellipse is farthest along some directions; whether there is room for them.
  bool refine(const std::vector<Vec2>& directions);

 private:
  Vec2 corner(double angle, double scale) const;
  void add(double angle);
  void make_rings();

  const ShapePart& part_;
  Ring inner_, outer_;
  bool sound_ = true;
  double room_ = 0, finest_ = 0;  // of the half-diameters; the least step of angles
  double width_ = 0;              // of the steps so far
  std::vector<double> angles_;    // ascending
};

/// Two parts of bodies; normals out of each.
using Sandwiches = std::array<Sandwich, 2>;
using Normals = std::array<std::vector<Vec2>, 2>;

/// Calls `look()` for what is known; it gives the normals along which more is to be known.
template <class Look>
void refine(Sandwiches& layers, const Look& look) {
  constexpr int kMostRounds = 24;
  bool finer = true;
  for (int round = 0; finer && round < kMostRounds; ++round) {
    if (!layers[0].is_sound() || !layers[1].is_sound()) return;
    const Normals normals = look();
    finer = layers[0].refine(normals[0]);
    finer |= layers[1].refine(normals[1]);
  }
}

/// How bodies lie that are between outer and inner ones.
inline StartPlace start_between(StartPlace outer, StartPlace inner) {
  return inner == StartPlace::inside ? inner : std::min(outer, StartPlace::boundary);
}

}  // namespace flatray
