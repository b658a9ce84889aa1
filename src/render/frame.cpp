#include "render/frame.h"

#include "image/srgb.h"

namespace flatray {

DrawList draw_list(const RenderPlan& plan, const Timeline& timeline, unsigned frame) {
  const Film& film = timeline.scene().film;
  const Colour& background = film.background;
  const FrameState state = at(timeline, frame);
  DrawContext context(timeline.scene(), state);
  for (const Pass* pass : plan.passes) pass->draw(context);
  return {film.width,
          film.height,
          {linear_from_srgb(background.r), linear_from_srgb(background.g),
           linear_from_srgb(background.b), static_cast<float>(background.a) / 255.0F},
          film.coverage,
          std::move(context).sorted_items()};
}

}  // namespace flatray
