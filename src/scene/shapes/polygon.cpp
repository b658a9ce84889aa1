#include <fmt/core.h>

#include "scene/outlines/ring.h"
#include "scene/shape.h"

namespace flatray::polygon_shape {
namespace {

constexpr KeyInfo kKeys[] = {{"points", "[[x, y] or a curve, ...]", kRequired},
                             {"fill_rule", R"("nonzero" or "even-odd")", R"("nonzero")"}};
constexpr Word<FillRule> kRules[] = {{"nonzero", FillRule::nonzero},
                                     {"even-odd", FillRule::even_odd}};

Result<Shape> build(Args& args) {
  const std::vector<Vec2> points = args.points("points");
  const auto rule = args.word<FillRule>("fill_rule", FillRule::nonzero, kRules);
  if (is_flat(points)) {
    args.warning(args.place("points"), "polygon has no area",
                 "it is taken as the segment or point it is");
    return flat_shape(points);
  }
  if (const std::optional<CrossingEdges> crossing = crossing_edges(points)) {
    if (rule == FillRule::nonzero)
      return fail(
          args.place("points", crossing->first),
          fmt::format("edges {} and {} of the polygon cross", crossing->first, crossing->second),
          R"(part them, or say fill_rule = "even-odd" to have it drawn only)");
    return Shape{.crossing_rings = {points}};
  }
  return ring_shape(points);
}

}  // namespace

extern const ShapeType entry = {"polygon", kKeys, &build};

}  // namespace flatray::polygon_shape
