#include "scene/outlines/rounded.h"

#include <numbers>

#include "geom/predicates.h"

namespace flatray {
namespace {

bool is_half(const EllipseArc& arc) { return arc.from == 0 && arc.sweep == std::numbers::pi; }

}  // namespace

double circle_radius(const Vec2& u) {
  return u.y() == 0 || u.x() == 0 ? u.cwiseAbs().maxCoeff() : u.stableNorm();
}

std::optional<Rounded> rounded_by(const ArcPath& path) {
  if (!path.closed || path.arcs.empty() || !path.arcs[0].is_circular()) return std::nullopt;
  const EllipseArc& one = path.arcs[0];
  if (path.is_ellipse()) return Rounded{one.centre, one.centre, circle_radius(one.u)};
  if (path.arcs.size() != 2) return std::nullopt;
  const EllipseArc& other = path.arcs[1];
  if (!is_half(one) || !is_half(other) || other.u != -one.u || other.v != -one.v)
    return std::nullopt;
  // The second half faces away from the first.
  const Vec2 across(one.v.y(), -one.v.x());
  if (cross_sign(across, other.centre - one.centre) != Sign::negative) return std::nullopt;
  return Rounded{other.centre, one.centre, path.radius > 0 ? path.radius : circle_radius(one.u)};
}

}  // namespace flatray
