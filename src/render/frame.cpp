#include "render/frame.h"

#include "render/gradient.h"

namespace flatray {

Result<DrawList> draw_list(const RenderPlan& plan, const Timeline& timeline, unsigned frame,
                           const FrameOptions& options) {
  const Film& film = timeline.scene().film;
  const FrameState state = at(timeline, frame);
  DrawContext context(timeline, state, plan.tracer);
  context.light = {options.threads, options.stop,         plan.raw_light,
                   plan.light_goal, options.light_report, plan.kept_light};
  for (const Pass* pass : plan.passes) pass->draw(context);
  FLATRAY_TRY(items, std::move(context).sorted_items());
  return DrawList{film.width,    film.height,       linear(film.background),
                  film.coverage, std::move(*items), film.rows};
}

}  // namespace flatray
