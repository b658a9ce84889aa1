#include <fmt/core.h>

#include "collide/edge_ray_meetings.h"
#include "study/stability/pair_scene.h"

namespace flatray::contact_choice {
namespace {

using Method = Result<std::vector<Meeting>> (*)(const Timeline& timeline, unsigned last_frame);

template <Outline kOutline>
Result<std::vector<Meeting>> meetings_of(const Timeline& timeline, unsigned last_frame) {
  return find_meetings(timeline, last_frame, kOutline);
}

Setting setting(const std::shared_ptr<PairScene>& scene, const char* name, Method method) {
  return {fmt::format("--method {}", name), 0,
          [=] { scene->tell(method(scene->timeline, scene->frames())); }, judged_pairs(scene)};
}

Result<ChoiceSettings> settings(const AccuracyContext& context) {
  FLATRAY_TRY(scene, pair_scene(context));
  ChoiceSettings made = pair_settings(**scene);
  made.laws = {};
  if (!refused_meetings(context.scene, Outline::box))
    made.settings.push_back(setting(*scene, "boxes", &meetings_of<Outline::box>));
  made.settings.push_back(setting(*scene, "minkowski", &meetings_of<Outline::own>));
  made.settings.push_back(setting(*scene, "edge-rays", &find_edge_ray_meetings));
  return made;
}

}  // namespace

extern const Choice entry = {"contact", "What does it cost to know who meets?",
                             ErrorKind::discretisation, &no_pairs, &settings};

}  // namespace flatray::contact_choice
