#include "study/stability/pair_scene.h"

#include <fmt/core.h>

#include "base/counted.h"
#include "scene/responses.h"

namespace flatray {

void PairScene::tell(const Result<std::vector<Meeting>>& meetings) {
  found = meetings.map([](const std::vector<Meeting>& all) {
    std::set<PairTruth::Pair> pairs;
    for (const Meeting& meeting : all) pairs.insert({meeting.a, meeting.b});
    return pairs;
  });
}

std::string no_pairs(const Scene& scene) {
  if (scene.entities.size() < 2) return "the scene has no two entities";
  if (scene.frames < 2) return "the scene has one frame";
  for (std::uint32_t i = 0; i < scene.entities.size(); ++i)
    if (!rests(scene, i)) return "";
  return "nothing moves";
}

Result<std::shared_ptr<PairScene>> pair_scene(const AccuracyContext& context) {
  if (auto refused = refused_meetings(context.scene)) return tl::unexpected(*std::move(refused));
  if (responds(context.scene))
    return tl::unexpected(Diagnostics{refused_responses(context.scene, "this choice")});
  auto scene = std::make_shared<PairScene>(context, reference_budget(context));
  if (scene->truth.compared.empty())
    return fail(context.scene.where, "the reference tells of no pair: " + scene->truth.words());
  return scene;
}

ChoiceSettings pair_settings(const PairScene& scene) {
  ChoiceSettings made;
  made.unit = "share of wrong answers among the pairs that meet or are said to";
  made.reference = scene.truth.words();
  if (scene.truth.cut > 0)
    made.cut = fmt::format("reference for {} more", counted(scene.truth.cut, "pair"));
  return made;
}

std::function<Result<Outcome>()> judged_pairs(const std::shared_ptr<PairScene>& scene) {
  return [scene] {
    return scene->found.map([&](const std::set<PairTruth::Pair>& found) {
      const PairErrors errors = pair_errors(scene->truth, found);
      const auto [share, doubt] =
          share_of(static_cast<double>(errors.missed + errors.invented),
                   static_cast<double>(scene->truth.meet.size() + errors.invented));
      const double half = scene->truth.cut == 0 ? 0 : doubt;
      return Outcome{share, half, {}, {half, std::nullopt, share, std::nullopt}};
    });
  };
}

}  // namespace flatray
