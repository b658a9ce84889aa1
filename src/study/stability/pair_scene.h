#pragma once
#include <functional>
#include <memory>

#include "collide/meetings.h"
#include "study/accuracy/accuracy.h"
#include "study/stability/pair_truth.h"

namespace flatray {

/// What choices about who meets share: a scene in motion, who meets in it, and who is told to.
struct PairScene {
  PairScene(const AccuracyContext& context, double seconds)
      : timeline(context.scene, context.seed, context.scene.frames),
        truth(pair_truth(timeline, context.scene.frames, seconds)) {}
  unsigned frames() const { return timeline.scene().frames; }
  void tell(const Result<std::vector<Meeting>>& meetings);

  Timeline timeline;
  PairTruth truth;
  Result<std::set<PairTruth::Pair>> found;
};

/// Why a scene has no pairs to look at, "" where it has.
std::string no_pairs(const Scene& scene);

/// Error   where what find_meetings() refuses moves, or no pair can be told.
Result<std::shared_ptr<PairScene>> pair_scene(const AccuracyContext& context);
/// Unit, reference and what was cut of it; no settings yet.
ChoiceSettings pair_settings(const PairScene& scene);
/// Of what is found when it is asked: all is discretisation but, where pairs were cut, the doubt
/// that the others leave, which is of sampling.
std::function<Result<Outcome>()> judged_pairs(const std::shared_ptr<PairScene>& scene);

}  // namespace flatray
