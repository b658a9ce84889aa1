#pragma once
#include <cmath>

#include "geom/bounds.h"
#include "geom/primitives/arc.h"
#include "geom/primitives/bezier.h"
#include "geom/primitives/wall.h"
#include "trace/kernels/walk.h"

namespace flatray {

/// Whether an arc surely ends about as near to its curve as rounding leaves its ends: else it may reach
/// beyond.
bool ends_on_curve(const Arc& wall);

/// That holds a curve, but for some roundings of its radius.
struct BoundingDisc {
  Vec2 centre;
  double radius;
  bool operator==(const BoundingDisc&) const = default;
};
BoundingDisc disc_about(const Arc& wall);
template <class Wall>
BoundingDisc disc_about_box(const Wall& wall) {
  const Bounds box = bounds_of(wall);
  return {box.centre(), (0.5 * box.size()).norm()};
}
template <class Wall>
BoundingDisc disc_about(const Wall& wall) {
  return disc_about_box(wall);
}

/// A ray beside such discs, of curves whose coordinates are at most `magnitude`.
class DiscFilter {
 public:
  DiscFilter(const Ray& ray, double magnitude);
  /// Whether a curve in the disc is surely not met, or surely later than `latest`.
  bool rules_out(const BoundingDisc& disc, double latest) const {
    const Vec2 w = disc.centre - origin_;
    const double beside = direction_.x() * w.y() - direction_.y() * w.x();
    const double reach = disc.radius * speed_ + slack_, ahead = direction_.dot(w);
    return std::fabs(beside) > reach || ahead + reach < 0 || latest < (ahead - reach) * per_square_;
  }

 private:
  const Vec2 origin_, direction_;
  const double speed_, slack_, per_square_;
};

/// The part of a curve that an arc is, in the form in which the curve is a circle of radius `size`: where a point has
/// a product with the unit vector `middle` of at least cut * size. cut = -4 of a whole curve, and of what has no such
/// form, as its ends do not lie on it or too close to each other.
struct ArcForm {
  double size = 0, cut = -4;
  Vec2 middle{1, 0};
  explicit ArcForm(const Arc& wall);
};

/// Whether a part of a wall may lie in the box of half sides `half` about low + middle.
class ArcPasses {
 public:
  ArcPasses(const Arc& wall, const Vec2& low);
  bool operator()(const Vec2& middle, const Vec2& half) const;

 private:
  const Arc& wall_;
  const ArcForm form_;
  const Bounds box_;
  const Vec2 low_;
  const bool is_sound_;
};
inline auto passes_of(const Arc& wall, const Vec2& low) { return ArcPasses(wall, low); }
template <class Wall>
auto passes_of(const Wall& wall, const Vec2& low) {
  return [&wall, low](const Vec2& middle, const Vec2& half) {
    return passes_near(wall, low + middle, half);
  };
}

/// The form of an arc for the lanes, in cells: `wall` is in cells, whose coordinates are at most `reach`. Of
/// what is no arc, and of those too large, too flat or not closed by their ends one of infinite doubt.
lanes::Curve curve_form_in_lanes(const Arc& wall, double reach);
inline lanes::Curve doubtful_curve() {
  lanes::Curve curve{};
  curve.doubt = static_cast<float>(kInfinity);
  return curve;
}

}  // namespace flatray
