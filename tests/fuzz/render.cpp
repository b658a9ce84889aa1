// needs: formats/toml
#include "fuzz/loading.h"
#include "render/frame.h"

namespace {

constexpr int kWidth = 48, kHeight = 32;

// Small enough for one second under the sanitizers.
flatray::LoadLimits limits() {
  flatray::LoadLimits limits;
  limits.max_entities = 50;
  limits.max_corners = 2000;
  return limits;
}

}  // namespace

// Scene text to pixels: frames drawn in a row are those drawn alone, with everything kept.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace flatray;
  const OneSecond limit;
  Result<LoadedScene> loaded =
      load_fuzzed("f.toml", text_of(data, size), {{"film.size", "[48, 32]"}}, limits());
  if (!loaded) return 0;
  Scene& scene = loaded->scene;
  for (RayPath& ray : scene.rays) ray.bounces = std::min(ray.bounces, 10U);
  const unsigned last = std::min(scene.frames, 3U);
  const RenderPlan plan = make_plan(scene, false), all = make_plan(scene, true);
  const Timeline timeline(scene, scene.seed, last);
  FrameDrawer<Image> drawer(FrameOptions{});
  for (unsigned frame = 1; frame <= last; ++frame) {
    Result<DrawList> list = draw_list(plan, timeline, frame);
    const Result<DrawList> kept = draw_list(all, timeline, frame);
    FLATRAY_CHECK(list.has_value() == kept.has_value(), "one list is refused, one is not");
    if (!list) return 0;
    const Image whole = render_image(*kept, {.keep_all = true});
    FLATRAY_CHECK(whole.width == kWidth && whole.height == kHeight, "another size");
    FLATRAY_CHECK(drawer.draw(std::move(*list)).pixels == whole.pixels, "kept pixels differ");
  }
  return 0;
}
