#include "base/counted.h"
#include "render/pass.h"

namespace flatray::entities_pass {
namespace {

Need need(const Scene& scene) {
  if (scene.entities.empty()) return skip("no entities");
  return run(counted(scene.entities.size(), "entity", "entities"));
}

void draw(DrawContext& context) {
  for (std::size_t i = 0; i < context.scene.entities.size(); ++i) {
    const Entity& entity = context.scene.entities[i];
    const EntityState& now = context.state.entities[i];
    if (now.gone) continue;
    context.place(entity.layer, entity.order, entity.where);
    context.fade(now.opacity, [&] {
      context.add_shape(shape_of(context.scene, now), entity_pose(context.state, i), now.fill,
                        now.stroke);
    });
  }
}

}  // namespace

extern const Pass entry = {"entities", &need, &draw};

}  // namespace flatray::entities_pass
