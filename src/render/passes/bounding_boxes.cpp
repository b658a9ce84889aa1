#include <algorithm>

#include "base/counted.h"
#include "geom/polygon.h"
#include "render/pass.h"

namespace flatray::bounding_boxes_pass {
namespace {

Need need(const Scene& scene) {
  const auto count = std::ranges::count_if(
      scene.entities, [](const Entity& entity) { return entity.bounding_box.has_value(); });
  if (count == 0) return skip("no entity asks for its box");
  return run(counted(count, "box", "boxes"));
}

void draw(DrawContext& context) {
  for (std::size_t i = 0; i < context.scene.entities.size(); ++i) {
    const Entity& entity = context.scene.entities[i];
    if (!entity.bounding_box || context.state.entities[i].gone) continue;
    const Bounds box = shape_extent(shape_of(context.scene, context.state.entities[i]),
                                    entity_pose(context.state, i));
    if (box.empty()) continue;
    context.place(entity.layer, entity.order, entity.where);
    Stroke stroke = *entity.bounding_box;
    stroke.scale = context.state.entities[i].scale;
    context.add_lines(ring_edges(box.corners()), stroke);
  }
}

}  // namespace

extern const Pass entry = {"bounding_boxes", &need, &draw};

}  // namespace flatray::bounding_boxes_pass
