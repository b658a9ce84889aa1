#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "scene/outlines/arcs.h"
#include "scene/shape.h"

namespace flatray::lens_shape {
namespace {

constexpr KeyInfo kKeys[] = {{"height", "number or a curve", kRequired},
                             {"thickness", "number or a curve", kRequired},
                             {"radii", "[left, right] or a curve", kRequired},
                             {"centre", "[x, y] or a curve", "[0, 0]"}};

// How far a face of a radius comes back from its vertex at the rim. Needs   |radius| >= half.
double sagitta(double radius, double half) {
  if (radius == 0) return 0;
  const double size = std::fabs(radius), rest = std::sqrt(size - half) * std::sqrt(size + half);
  return std::copysign(half * (half / (size + rest)), radius);
}

// Counter-clockwise about the lens: up the right face (outward = 1), down the left one (-1).
void add_face(const Vec2& vertex, double radius, double half, double outward,
              std::vector<EllipseArc>& arcs) {
  if (radius == 0) {
    for (const double end : {-outward * half, outward * half})
      arcs.push_back(corner_at(vertex + Vec2(0, end)));
    return;
  }
  const double angle = portable::asin(half / std::fabs(radius));
  arcs.push_back({Vec2(vertex - Vec2(outward * radius, 0)),
                  {outward * radius, 0},
                  {0, outward * std::fabs(radius)},
                  -angle,
                  2 * angle});
}

Result<Shape> build(Args& args) {
  const Vec2 radii = args.point("radii"), centre = args.point("centre");
  const double half = 0.5 * args.size("height"), depth = 0.5 * args.size("thickness");
  constexpr double kFlat = 1e6;  // beyond it rounding the centre would show in the thickness
  for (const double radius : {radii.x(), radii.y()}) {
    if (radius == 0) continue;
    if (!(std::fabs(radius) >= half))
      return fail(args.place("radii"),
                  "a face of the lens is less than half as wide as the lens is high",
                  "write radii of half the height and more, or 0 for a flat face");
    if (!(std::fabs(radius) <= 2 * kFlat * std::min(half, depth)))
      return fail(args.place("radii"), "a face of the lens is flat but for rounding",
                  "write 0 for a flat face, or radii of at most 10^6 times height and thickness");
  }
  if (!(sagitta(radii.x(), half) + sagitta(radii.y(), half) <= 2 * depth))
    return fail(args.place("thickness"), "the faces of the lens cross before they come to its rim",
                "write a larger thickness, which is that at the axis, or a smaller height");
  ArcPath path;
  add_face(centre + Vec2(depth, 0), radii.y(), half, 1, path.arcs);
  add_face(centre - Vec2(depth, 0), radii.x(), half, -1, path.arcs);
  return shape_of(std::move(path));
}

}  // namespace

extern const ShapeType entry = {"lens", kKeys, &build, true};

}  // namespace flatray::lens_shape
