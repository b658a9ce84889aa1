#include "base/counted.h"
#include "render/pass.h"

namespace flatray::chambers_pass {
namespace {

Need need(const Scene& scene) {
  if (scene.chambers.empty()) return skip("no chamber");
  return run("a chamber with " + counted(scene.chambers.front().pillars.size(), "pillar"));
}

void draw(DrawContext& context) {
  const Scene& scene = context.scene;
  for (const Chamber& chamber : scene.chambers) {
    context.place(chamber.layer, chamber.order, chamber.where);
    context.fade(chamber.opacity, [&] {
      const bool whole = chamber.holes.empty();
      context.add_shape(scene.shapes[chamber.shape], world_pose(context.state), chamber.fill,
                        whole ? chamber.stroke : std::nullopt);
      if (!whole)
        context.add_shape(chamber.kept, world_pose(context.state), std::nullopt, chamber.stroke);
      for (const Chamber::Pillar& pillar : chamber.pillars)
        context.add_shape(scene.shapes[pillar.shape], pillar_pose(context.state, pillar),
                          pillar.fill, pillar.stroke);
    });
  }
}

}  // namespace

extern const Pass entry = {"chambers", &need, &draw};

}  // namespace flatray::chambers_pass
