#include <fmt/core.h>

#include <memory>

#include "collide/edge_ray_meetings.h"
#include "scene/responses.h"
#include "study/accuracy.h"
#include "study/pair_truth.h"

namespace flatray {
namespace {

// A scene in motion, who meets in it, and who is told to.
struct Meetings {
  Meetings(const AccuracyContext& context, double seconds)
      : timeline(context.scene, context.seed, context.scene.frames),
        truth(pair_truth(timeline, context.scene.frames, seconds)) {}
  Timeline timeline;
  PairTruth truth;
  std::vector<Meeting> found;
};

using Method = std::vector<Meeting> (*)(const Timeline& timeline, unsigned last_frame);

std::vector<Meeting> exact(const Timeline& timeline, unsigned last_frame) {
  return find_meetings(timeline, last_frame);
}
std::vector<Meeting> boxes(const Timeline& timeline, unsigned last_frame) {
  return find_meetings(timeline, last_frame, Outline::box);
}

Setting setting(const std::shared_ptr<Meetings>& meetings, const char* name, Method method) {
  return {fmt::format("--method {}", name), 0,
          [=] { meetings->found = method(meetings->timeline, meetings->timeline.scene().frames); },
          [meetings] {
            std::set<PairTruth::Pair> pairs;
            for (const Meeting& meeting : meetings->found) pairs.insert({meeting.a, meeting.b});
            return Outcome{wrong_share(meetings->truth, pair_errors(meetings->truth, pairs))};
          }};
}

Result<ChoiceSettings> settings(const AccuracyContext& context) {
  if (auto refused = refused_meetings(context.scene)) return tl::unexpected(*std::move(refused));
  if (responds(context.scene))
    return tl::unexpected(Diagnostics{refused_responses(context.scene, "this choice")});
  const auto meetings = std::make_shared<Meetings>(context, reference_budget(context));
  if (meetings->truth.compared.empty())
    return fail(named_place(context.scene.name),
                "no polygon moves beside another, and the reference knows no discs");
  ChoiceSettings made;
  made.unit = "share of the pairs that meet, or are told to, that are told wrong";
  made.reference = meetings->truth.words();
  if (meetings->truth.cut > 0)
    made.cut = fmt::format("reference for {} pairs more", meetings->truth.cut);
  made.ordered = false;
  made.settings = {setting(meetings, "boxes", &boxes), setting(meetings, "minkowski", &exact),
                   setting(meetings, "edge-rays", &find_edge_ray_meetings)};
  return made;
}

}  // namespace

namespace choice_entries {
extern const Choice contact = {"contact", "What does it cost to know who meets?",
                               ErrorKind::discretisation, &no_pairs, &settings};
}  // namespace choice_entries

}  // namespace flatray
