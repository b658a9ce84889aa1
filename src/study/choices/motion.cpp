
#include "base/counted.h"
#include "collide/broad_phase.h"
#include "study/stability/pair_scene.h"

namespace flatray::motion_choice {
namespace {

// Who overlaps at one instant: nothing moves while it is looked at.
void look(const Scene& scene, const std::vector<EntityState>& now,
          std::set<PairTruth::Pair>& found) {
  std::vector<MovingShape> bodies;
  std::vector<Bounds> boxes;
  for (const EntityState& state : now) {
    bodies.push_back({&shape_of(scene, state), pose(state.at, state.angle, state.scale), {0, 0}});
    boxes.push_back(shape_bounds(*bodies.back().shape, bodies.back().place));
  }
  for (const auto& [a, b] : overlapping_pairs(boxes))
    if (!(rests(scene, a) && rests(scene, b)) && !shapes_meet(bodies[a], bodies[b], {0, 0}).empty())
      found.insert({a, b});
}

std::set<PairTruth::Pair> sampled(const PairScene& motion, int samples) {
  std::set<PairTruth::Pair> found;
  for (unsigned frame = 1; frame <= motion.frames(); ++frame)
    for (int k = 0; k < (frame == motion.frames() ? 1 : samples); ++k)
      look(motion.timeline.scene(),
           entity_states(motion.timeline, frame, static_cast<double>(k) / samples), found);
  return found;
}

Setting instants(const std::shared_ptr<PairScene>& scene, int samples) {
  return {counted(samples, "instant") + " a frame", static_cast<double>(samples),
          [=] { scene->found = sampled(*scene, samples); }, judged_pairs(scene)};
}

Result<ChoiceSettings> settings(const AccuracyContext& context) {
  FLATRAY_TRY(scene, pair_scene(context));
  ChoiceSettings made = pair_settings(**scene);
  made.grows = "instants a frame";
  made.settings = {instants(*scene, 1),
                   {"all instants", 0,
                    [all = *scene] { all->tell(find_meetings(all->timeline, all->frames())); },
                    judged_pairs(*scene)}};
  for (int samples = 2; samples <= 64; samples *= 2)
    made.settings.push_back(instants(*scene, samples));
  return made;
}

}  // namespace

extern const Choice entry = {"motion", "What does it cost not to miss what meets between frames?",
                             ErrorKind::discretisation, &no_pairs, &settings};

}  // namespace flatray::motion_choice
