#include "base/counted.h"
#include "render/light_picture.h"
#include "render/pass.h"

namespace flatray {
namespace {

Need need(const Scene& scene) {
  if (scene.lamps.empty()) return skip("no lamps");
  return run(counted(scene.lamps.size(), "lamp"));
}

void draw(DrawContext& context) {
  const Scene& scene = context.scene;
  if (scene.lamps.empty()) return;
  const TracedLight traced =
      trace_frame_light(scene, context.state, context.tracer, context.timeline.seed(),
                        context.light.threads, context.light.stop);
  context.place(scene.light.layer, 0, scene.light.where);
  context.add_light(
      std::make_shared<LightPicture>(light_picture(traced, scene.light, context.light.raw)));
}

}  // namespace

extern const Pass light_pass;
const Pass light_pass = {"light", &need, &draw};

}  // namespace flatray
