#pragma once
#include <optional>
#include <span>
#include <vector>

#include "geom/primitives/arc.h"

namespace flatray {

/// Polygons about and in an ellipse, which touch it at chosen angles of u and v: made finer where that
/// matters. Proofs: docs/NUMERICS.md.
class Sandwich {
 public:
  using Ring = std::vector<Vec2>;

  /// Needs   a finite ellipse with an area.
  explicit Sandwich(const Ellipse& curve);

  Ring inner() const;
  Ring outer() const;

  /// Whether rounding leaves anything of it.
  bool is_sound() const { return room_ < 0x1p-10; }
  /// More corners where it is farthest along some directions; whether there is room for them.
  bool refine(const std::vector<Vec2>& directions);

 private:
  Vec2 corner(double angle, double scale) const;
  void add(double angle);

  Ellipse curve_;
  double room_ = 0, finest_ = 0;  // of the half-diameters; the least step of angles
  double width_ = 0;              // of the steps so far
  std::vector<double> angles_;    // ascending
};

/// The core of a body; of one that is an ellipse instead polygons in and about it.
class CoreLayers {
 public:
  CoreLayers(std::span<const Vec2> core, const std::optional<Ellipse>& curve);

  std::span<const Vec2> inner() const { return curve_ ? std::span<const Vec2>(inner_) : core_; }
  std::span<const Vec2> outer() const { return curve_ ? std::span<const Vec2>(outer_) : core_; }

  /// Whether the polygons are what they should be, in spite of rounding.
  bool is_sound() const { return sound_; }
  /// As Sandwich does.
  bool refine(const std::vector<Vec2>& directions);

 private:
  void make_rings();

  std::span<const Vec2> core_;
  std::optional<Sandwich> curve_;
  Sandwich::Ring inner_, outer_;
  bool sound_ = true;
};

}  // namespace flatray
