#include "scene/outlines/ring.h"
#include "scene/shape.h"

namespace flatray::tokarsky_shape {
namespace {

constexpr KeyInfo kKeys[] = {{"size", "number or a curve", kRequired},
                             {"at", "[x, y] or a curve", "[0, 0]"}};

constexpr int kCorners[][2] = {{0, 2}, {1, 2}, {1, 1}, {2, 1}, {2, 0}, {3, 1}, {4, 1},
                               {4, 0}, {5, 1}, {6, 1}, {6, 0}, {7, 1}, {7, 2}, {8, 2},
                               {8, 3}, {7, 3}, {6, 4}, {6, 3}, {5, 3}, {5, 2}, {3, 2},
                               {3, 3}, {2, 3}, {2, 4}, {1, 4}, {1, 3}};

// Tokarsky 1995, "Polygonal rooms not illuminable from every interior point": half squares,
// mirrored at their sides. A ray from a sharp corner of one never comes back to it, and (2, 2) and
// (6, 2) are copies of one such corner, the only ones inside.
Result<Shape> build(Args& args) {
  const Vec2 at = args.point("at");
  const double size = args.size("size");
  if (args.gone()) return Shape{};
  std::vector<Vec2> ring;
  for (const auto& [x, y] : kCorners) ring.push_back(at + size * Vec2(x, y));
  if (is_flat(ring) || crossing_edges(ring))
    return fail(args.place("size"), "the corners of the room are lost in rounding",
                "write a larger size, or a place nearer to 0");
  return ring_shape(ring);
}

}  // namespace

extern const ShapeType entry = {"tokarsky", kKeys, &build};

}  // namespace flatray::tokarsky_shape
