#include "app/frames/frame_source.h"

#include <fmt/core.h>

#include "app/interrupt.h"

namespace flatray {
namespace {

// The goal of the job's light, of which `told` is told.
LightGoal told_goal(const RenderJob& job, const Told& told) {
  LightGoal goal = job.light.goal();
  if (told)
    goal.told = [&told](const TracedLight& light, std::optional<double> error) {
      told(fmt::format("{} rays{}", light.counts.rays,
                       error ? fmt::format(", error {:.2g}", *error) : std::string()));
    };
  return goal;
}

}  // namespace

RenderPlan plan_of(const RenderJob& job, const LightGoal& goal) {
  RenderPlan plan = make_plan(job.scene, job.keep_all, job.tracer);
  plan.light_goal = &goal;
  const bool film = job.output.format().of_film != nullptr;
  plan.still = plan.still && !film;  // each names its frame
  plan.still_light = plan.still_light && !film && !job.view;
  plan.raw_light = job.output.format().of_picture == nullptr;
  return plan;
}

FrameSource::FrameSource(const RenderJob& job, const Timeline& timeline, unsigned first,
                         std::size_t count, unsigned threads, const Told& told)
    : job_(job), timeline_(timeline), goal_(told_goal(job, told)), plan_(plan_of(job, goal_)) {
  if (plan_.still) {
    FrameEncoder encoder(job_, threads, &interrupted);
    Result<const Encoded*> made = encoder.encode(plan_, timeline_, first);
    if (!made)
      problems_ = std::move(made).error();
    else if (*made != nullptr)
      still_ = **made;
    drawn_ = encoder.counts();
    encoded_ = encoder.encoded();
  } else if (plan_.still_light && count > 1) {
    kept_light_ = show_light(timeline_, at(timeline_, first), job_.tracer,
                             {threads, &interrupted, plan_.raw_light, &goal_});
    plan_.kept_light = &kept_light_;
  }
}

Result<const Encoded*> FrameSource::encode(unsigned frame, FrameEncoder& encoder) const {
  if (!plan_.still) return encoder.encode(plan_, timeline_, frame);
  if (!problems_.empty()) return tl::unexpected(problems_);
  return still_ ? &*still_ : nullptr;
}

}  // namespace flatray
