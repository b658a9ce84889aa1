#include <fmt/core.h>

#include <cmath>
#include <memory>

#include "base/check.h"
#include "image/tile.h"
#include "render/backend.h"
#include "study/accuracy.h"
#include "study/point_samples.h"

namespace flatray {
namespace {

constexpr int kTruthSide = 16;

// A picture, and what the settings draw of it.
struct Film {
  DrawList list;
  LinearImage truth, drawn;
  unsigned threads = 1;
};

double rms(const LinearImage& a, const LinearImage& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const double off = static_cast<double>(a.pixels[i]) - static_cast<double>(b.pixels[i]);
    sum += off * off;
  }
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(a.pixels.size(), 1)));
}

Image developed(const LinearImage& light) {
  Image image(light.width, light.height, 3);
  Tile tile{0, 0, light.width, light.height, {}};
  for (std::size_t i = 0; i < light.pixels.size(); i += 3)
    tile.rgba.insert(tile.rgba.end(),
                     {light.pixels[i], light.pixels[i + 1], light.pixels[i + 2], 1.0F});
  develop(tile, image);
  return image;
}

std::function<Outcome()> judged(const std::shared_ptr<Film>& film) {
  return [film] { return Outcome{rms(film->drawn, film->truth), 0, developed(film->drawn)}; };
}

std::vector<SamplePlace> grid(int side) {
  std::vector<SamplePlace> places;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) places.push_back({(x + 0.5) / side, (y + 0.5) / side});
  return places;
}

// Each pixel by the mean of side * side samples on a grid.
Setting samples(const std::shared_ptr<Film>& film, int side) {
  const std::string words =
      side == 1 ? "pixel centres" : fmt::format("{} samples a pixel", side * side);
  return {words, static_cast<double>(side * side),
          [film, side] { film->drawn = mean_light(film->list, grid(side), film->threads); },
          judged(film)};
}

// What GL makes of it, where there is one.
void add_gl(std::vector<Setting>& settings, const std::shared_ptr<Film>& film) {
  for (const Backend* backend : backends())
    for (const unsigned count : {4U, 16U}) {
      if (std::string_view(backend->name) != "gl") continue;
      auto opened = backend->open({film->threads, count});
      if (!opened) return;
      const std::shared_ptr<Renderer> gl = std::move(*opened);
      if (!gl->draw(film->list, {std::nullopt, film->threads}, film->drawn)) return;
      const auto work = [film, gl] {
        FLATRAY_CHECK(gl->draw(film->list, {std::nullopt, film->threads}, film->drawn));
      };
      settings.push_back({fmt::format("--backend gl, {} samples", count), 0, work, judged(film)});
    }
}

std::string left_out(const Scene& scene) {
  return scene.film.coverage == Coverage::centre ? "the scene asks for pixel centres" : "";
}

// Exact areas are exact for each thing alone: where two things meet or lie on each other in a pixel,
// blending them as if they had nothing to do with each other is an error, which samples do not make.
Result<ChoiceSettings> settings(const AccuracyContext& context) {
  const unsigned frame = (context.scene.frames + 1) / 2;
  const Timeline timeline(context.scene, context.seed, frame);
  auto list = draw_list(make_plan(context.scene, false), timeline, frame);
  if (!list) return tl::unexpected(list.error());
  const auto film = std::make_shared<Film>();
  film->list = std::move(*list);
  film->threads = context.threads;
  film->truth = mean_light(film->list, grid(kTruthSide), context.threads);
  const double doubt =
      rms(film->truth, mean_light(film->list, grid(kTruthSide - 1), context.threads));
  ChoiceSettings made;
  made.unit = "root mean square of linear light, 1 is white";
  made.reference = fmt::format(
      "frame {} by {} samples a pixel, from which {} differ by {:.2g}; blended after areas, things "
      "that share a pixel are taken as independent",
      frame, kTruthSide * kTruthSide, (kTruthSide - 1) * (kTruthSide - 1), doubt);
  made.grows = "samples a pixel";
  made.settings = {samples(film, 1),
                   {"exact area", 0,
                    [film] {
                      film->drawn = render_linear(film->list, {std::nullopt, film->threads});
                    },
                    judged(film)}};
  for (const int side : {2, 4, 8}) made.settings.push_back(samples(film, side));
  add_gl(made.settings, film);
  return made;
}

}  // namespace

namespace choice_entries {
extern const Choice coverage = {"coverage",
                                "What does it cost to know how much of a pixel a thing covers?",
                                ErrorKind::discretisation, &left_out, &settings};
}  // namespace choice_entries

}  // namespace flatray
