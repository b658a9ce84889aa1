#include <fmt/core.h>

#include <memory>

#include "collide/broad_phase.h"
#include "collide/meetings.h"
#include "scene/responses.h"
#include "study/accuracy.h"
#include "study/pair_truth.h"

namespace flatray {
namespace {

struct Motion {
  Motion(const AccuracyContext& context, double seconds)
      : timeline(context.scene, context.seed, context.scene.frames),
        truth(pair_truth(timeline, context.scene.frames, seconds)) {}
  unsigned frames() const { return timeline.scene().frames; }

  Timeline timeline;
  PairTruth truth;
  std::set<PairTruth::Pair> found;
};

// Who overlaps at one instant between two frames: nothing moves while it is looked at.
void look(const Scene& scene, const std::vector<EntityState>& now,
          const std::vector<EntityState>& next, double part, std::set<PairTruth::Pair>& found) {
  std::vector<MovingShape> bodies;
  std::vector<Bounds> boxes;
  for (std::size_t i = 0; i < now.size(); ++i) {
    const Vec2 at = now[i].at + part * (next[i].at - now[i].at);
    bodies.push_back({&shape_of(scene, now[i]), pose(at, now[i].angle, now[i].scale), {0, 0}});
    boxes.push_back(shape_bounds(*bodies.back().shape, bodies.back().place));
  }
  for (const auto& [a, b] : overlapping_pairs(boxes))
    if (!(rests(scene, a) && rests(scene, b)) && !shapes_meet(bodies[a], bodies[b], {0, 0}).empty())
      found.insert({a, b});
}

std::set<PairTruth::Pair> sampled(const Motion& motion, int samples) {
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

std::function<Outcome()> judged(const std::shared_ptr<Motion>& motion) {
  return [motion] {
    return Outcome{wrong_share(motion->truth, pair_errors(motion->truth, motion->found))};
  };
}

Setting instants(const std::shared_ptr<Motion>& motion, int samples) {
  return {fmt::format("{} instant{} a frame", samples, samples == 1 ? "" : "s"),
          static_cast<double>(samples), [=] { motion->found = sampled(*motion, samples); },
          judged(motion)};
}

Setting continuous(const std::shared_ptr<Motion>& motion) {
  return {"all instants", 0,
          [motion] {
            motion->found.clear();
            for (const Meeting& meeting : find_meetings(motion->timeline, motion->frames()))
              motion->found.insert({meeting.a, meeting.b});
          },
          judged(motion)};
}

Result<ChoiceSettings> settings(const AccuracyContext& context) {
  if (auto refused = refused_meetings(context.scene)) return tl::unexpected(*std::move(refused));
  if (responds(context.scene))
    return tl::unexpected(Diagnostics{refused_responses(context.scene, "this choice")});
  const auto motion = std::make_shared<Motion>(context, reference_budget(context));
  if (motion->truth.compared.empty())
    return fail(named_place(context.scene.name),
                "no polygon moves beside another, and the reference knows no discs");
  ChoiceSettings made;
  made.unit = "share of the pairs that meet, or are told to, that are told wrong";
  made.reference = motion->truth.words();
  if (motion->truth.cut > 0)
    made.cut = fmt::format("reference for {} pairs more", motion->truth.cut);
  made.grows = "instants a frame";
  made.settings.push_back(continuous(motion));
  for (int samples = 1; samples <= 64; samples *= 2)
    made.settings.push_back(instants(motion, samples));
  return made;
}

}  // namespace

namespace choice_entries {
extern const Choice motion = {"motion", "What does it cost not to miss what meets between frames?",
                              ErrorKind::discretisation, &no_pairs, &settings};
}  // namespace choice_entries

}  // namespace flatray
