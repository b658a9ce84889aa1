#include "render/plan.h"

#include <fmt/core.h>

#include <map>

#include "anim/motion.h"
#include "base/counted.h"
#include "scene/responses.h"
#include "transport/light/forward.h"

namespace flatray {
namespace {

// How many entities do what where they meet another: "100 bounce, 4 mark"; "" for none.
std::string responses_of(const Scene& scene) {
  std::map<Response, std::size_t> counts;
  for (const Entity& entity : scene.entities) ++counts[response_of(scene, entity)];
  std::string text;
  for (const auto& [response, count] : counts)
    if (response != Response::none)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name(response));
  return text;
}

}  // namespace

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
  if (!scene.lamps.empty())
    plan.choices.push_back(
        {"light", counted(rays_traced(scene.light.rays), "ray"),
         scene.light.sampler == LightSampler::sorted
             ? "bounces in order of place, with numbers of a net: less noise than random ones"
             : "random numbers, as asked"});
  const std::string responses = responses_of(scene);
  plan.choices.push_back({"responses", responses.empty() ? "left out" : "simulated once",
                          responses.empty() ? "nothing responds to contact" : responses});
  const std::string motion = reason_to_move(scene), light_motion = reason_for_light_to_move(scene);
  plan.still = motion.empty() && !keep_all;
  plan.still_light = light_motion.empty() && !keep_all && !scene.lamps.empty();
  if (!motion.empty() && !scene.lamps.empty())
    plan.choices.push_back({"light of frames", plan.still_light ? "traced once" : "each traced",
                            !light_motion.empty() ? light_motion
                            : keep_all ? "it does not move, but nothing is to be left out"
                                       : "nothing moves that it comes from or to"});
  plan.choices.push_back({"frames", plan.still ? "drawn once" : "each drawn",
                          !motion.empty() ? motion
                          : keep_all      ? "nothing moves, but nothing is to be left out"
                                          : "nothing moves"});
  return plan;
}

}  // namespace flatray
