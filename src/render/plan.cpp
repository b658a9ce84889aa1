#include "render/plan.h"

#include "anim/motion.h"

namespace flatray {

RenderPlan make_plan(const Scene& scene, bool keep_all, const Tracer* tracer) {
  RenderPlan plan;
  plan.tracer = tracer;
  for (const Pass* pass : passes()) {
    const Need need = pass->need(scene);
    if (need.needed || keep_all) plan.passes.push_back(pass);
    plan.choices.push_back({std::string("pass ") + pass->name,
                            need.needed ? "kept" : (keep_all ? "kept (asked)" : "left out"),
                            need.reason});
  }
  const std::string motion = reason_to_move(scene);
  plan.still = motion.empty() && !keep_all;
  plan.choices.push_back({"frames", plan.still ? "drawn once" : "each drawn",
                          !motion.empty() ? motion
                          : keep_all      ? "nothing moves (asked)"
                                          : "nothing moves"});
  return plan;
}

}  // namespace flatray
