#include "base/counted.h"
#include "render/light/light_run.h"
#include "render/pass.h"
#include "scene/lamp.h"

namespace flatray::light_pass {
namespace {

Need need(const Scene& scene) {
  if (scene.lamps.empty()) return skip("no lamps");
  const std::string lamps = counted(scene.lamps.size(), "lamp");
  if (scene.light.estimator == LightEstimator::backward)
    return run(lamps + ", backward from pixels, as the scene asks");
  if (scene.light.estimator == LightEstimator::forward) return run(lamps + ", forward");
  auto hindrance = why_not_backward(scene);
  if (!hindrance) hindrance = why_noisy_backward(scene);
  return run(hindrance ? lamps + ", forward: " + hindrance->message
                       : lamps + ", forward, but for views of a small part of the walls");
}

void draw(DrawContext& context) {
  const Scene& scene = context.scene;
  if (scene.lamps.empty()) return;
  const LightRun& run = context.light;
  const ShownLight light = run.kept != nullptr
                               ? *run.kept
                               : show_light(context.timeline, context.state, context.tracer, run);
  if (run.report != nullptr) *run.report = light.report;
  context.place(scene.light.layer, 0, scene.light.where);
  context.add_light(light.picture);
}

}  // namespace

extern const Pass entry = {"light", &need, &draw};

}  // namespace flatray::light_pass
