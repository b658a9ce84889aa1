#include "render/gl/renderer.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "image/pixel_runs.h"
#include "render/gl/batches.h"
#include "render/gl/loaded_module.h"

namespace flatray::gl {
namespace {

// Pixels drawn at a time: their samples, 20 bytes each, stay under 100 MB; 36 where something is
// faded as one.
constexpr int kTilePixels = 1 << 20;

// Samples of a pixel come from drawing it several times, each time moved a little. Both
// coordinates take every value of a regular row once, as the rooks of chess stand.
std::vector<std::array<float, 2>> shifts(unsigned times) {
  std::vector<std::array<float, 2>> all;
  const auto place = [&](unsigned i) {
    return (static_cast<float>(i) - 0.5F * static_cast<float>(times - 1)) /
           static_cast<float>(4 * times);
  };
  const unsigned root = times == 16 ? 4 : times == 4 ? 2 : 1;
  for (unsigned i = 0; i < times; ++i) all.push_back({place(i), place(i % root * root + i / root)});
  return all;
}

// Without MSAA each of its four samples is a picture of its own, moved so that centres see it.
std::vector<std::array<float, 2>> one_by_one(const std::vector<std::array<float, 2>>& moved) {
  constexpr std::array<std::array<float, 2>, 4> kPlaces = {
      {{0.375F, 0.125F}, {0.875F, 0.375F}, {0.125F, 0.625F}, {0.625F, 0.875F}}};
  std::vector<std::array<float, 2>> all;
  for (const std::array<float, 2>& shift : moved)
    for (const std::array<float, 2>& place : kPlaces)
      all.push_back({shift[0] + 0.5F - place[0], shift[1] + 0.5F - place[1]});
  return all;
}

class GlRenderer final : public Renderer {
 public:
  GlRenderer(std::unique_ptr<LoadedModule> module, unsigned samples)
      : module_(std::move(module)), samples_(samples) {}

  Result<void> draw(const DrawList& list, const FrameOptions& options, Image& out) const override {
    return render(list, options, out);
  }

  Result<void> draw(const DrawList& list, const FrameOptions& options,
                    LinearImage& out) const override {
    return render(list, options, out);
  }

  std::string description() const override {
    return fmt::format("gl: {}, {} samples", module_->info().version, samples_);
  }

 private:
  // Tiles are cut by the size of the picture alone.
  template <class Picture>
  Result<void> render(const DrawList& list, const FrameOptions& options, Picture& out) const {
    for (const DrawItem& item : list.items)
      if (item.light)
        return fail(named_place("--backend"), "the GL back ends add no light of lamps",
                    "leave --backend out: the software back end does", Trouble::unavailable);
    const PixelBox crop = crop_of(list, options);
    shape_picture(crop, list, out);
    const int width = std::min(crop.width, FLATRAY_GL_TILE);
    const int rows = std::clamp(kTilePixels / std::max(width, 1), 1, FLATRAY_GL_TILE);
    std::vector<Light> colours;
    for (int y = 0; y < crop.height; y += rows)
      for (int x = 0; x < crop.width; x += width) {
        if (options.stopped()) return {};
        const PixelBox box{crop.x + x, crop.y + y, std::min(width, crop.width - x),
                           std::min(rows, crop.height - y)};
        if (auto drawn = draw_tile(list, box, colours); !drawn) return drawn;
        put_rows(colours, box.width, x, y, out);
      }
    return {};
  }

  Result<void> draw_tile(const DrawList& list, const PixelBox& box,
                         std::vector<Light>& colours) const {
    const Batches made = batches(list, box);
    colours.resize(static_cast<std::size_t>(box.width) * static_cast<std::size_t>(box.height));
    const LinearColour& under = list.background;
    const bool centre = list.coverage == Coverage::centre;
    const FlatrayGlInfo& info = module_->info();
    std::vector<std::array<float, 2>> moved = {{0, 0}};
    if (!centre) moved = shifts(samples_ / 4);
    if (!centre && info.most_samples < 4) moved = one_by_one(moved);
    return module_->draw(
        {.x = box.x,
         .y = box.y,
         .width = box.width,
         .height = box.height,
         .samples = centre ? 1 : info.most_samples,
         .shifts = reinterpret_cast<const float(*)[2]>(moved.data()),
         .shift_count = moved.size(),
         .background = {under.r * under.a, under.g * under.a, under.b * under.a, under.a},
         .vertices = made.vertices.data(),
         .vertex_count = made.vertices.size(),
         .batches = made.batches.data(),
         .batch_count = made.batches.size(),
         .gradients = made.gradients.data(),
         .gradient_count = made.gradients.size(),
         .stops = made.stops.data(),
         .stop_count = made.stops.size(),
         .rgba = colours.front().data()});
  }

  std::unique_ptr<LoadedModule> module_;
  unsigned samples_;
};

}  // namespace

Result<std::unique_ptr<Renderer>> open_renderer(const char* maker, const BackendChoice& choice) {
  // Several frames at a time keep the cores busy; one at a time leaves the others to Mesa.
  FLATRAY_TRY(module, LoadedModule::open(maker, choice.threads));
  return std::make_unique<GlRenderer>(std::move(*module), choice.samples);
}

}  // namespace flatray::gl
