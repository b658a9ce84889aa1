#include <fmt/core.h>

#include "base/counted.h"
#include "collide/broad_phase.h"
#include "study/pair_scene.h"

namespace flatray {
namespace {

// Who overlaps at one instant between two frames: nothing moves while it is looked at.
void look(const Scene& scene, const std::vector<EntityState>& now,
          const std::vector<EntityState>& next, double part, std::set<PairTruth::Pair>& found) {
  std::vector<MovingShape> bodies;
  std::vector<Bounds> boxes;
  for (std::size_t i = 0; i < now.size(); ++i) {
    const Vec2 at = now[i].at + part * (next[i].at - now[i].at);
    const auto entity = static_cast<std::uint32_t>(i);
    const double turn = turn_between(scene, entity, now[i].angle, next[i].angle);
    bodies.push_back(
        {&shape_of(scene, now[i]), pose(at, now[i].angle + part * turn, now[i].scale), {0, 0}});
    boxes.push_back(shape_bounds(*bodies.back().shape, bodies.back().place));
  }
  for (const auto& [a, b] : overlapping_pairs(boxes))
    if (!(rests(scene, a) && rests(scene, b)) && !shapes_meet(bodies[a], bodies[b], {0, 0}).empty())
      found.insert({a, b});
}

std::set<PairTruth::Pair> sampled(const PairScene& motion, int samples) {
  std::set<PairTruth::Pair> found;
  std::vector<EntityState> now = entity_states(motion.timeline, 1);
  for (unsigned frame = 1; frame <= motion.frames(); ++frame) {
    const bool last = frame == motion.frames();
    std::vector<EntityState> next = last ? now : entity_states(motion.timeline, frame + 1);
    for (int k = 0; k < (last ? 1 : samples); ++k)
      look(motion.timeline.scene(), now, next, static_cast<double>(k) / samples, found);
    now = std::move(next);
  }
  return found;
}

Setting instants(const std::shared_ptr<PairScene>& scene, int samples) {
  return {counted(samples, "instant") + " a frame", static_cast<double>(samples),
          [=] { scene->found = sampled(*scene, samples); }, judged_pairs(scene)};
}

Setting continuous(const std::shared_ptr<PairScene>& scene) {
  return {"all instants", 0,
          [scene] { scene->tell(find_meetings(scene->timeline, scene->frames())); },
          judged_pairs(scene)};
}

Result<ChoiceSettings> settings(const AccuracyContext& context) {
  const auto scene = pair_scene(context);
  if (!scene) return tl::unexpected(scene.error());
  ChoiceSettings made = pair_settings(**scene);
  made.grows = "instants a frame";
  made.settings.push_back(continuous(*scene));
  for (int samples = 1; samples <= 64; samples *= 2)
    made.settings.push_back(instants(*scene, samples));
  return made;
}

}  // namespace

namespace choice_entries {
extern const Choice motion = {"motion", "What does it cost not to miss what meets between frames?",
                              ErrorKind::discretisation, &no_pairs, &settings};
}  // namespace choice_entries

}  // namespace flatray
