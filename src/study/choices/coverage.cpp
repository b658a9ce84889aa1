#include <fmt/core.h>

#include <array>

#include "base/check.h"
#include "base/entry_named.h"
#include "base/processor_time.h"
#include "image/compare.h"
#include "render/backend.h"
#include "study/accuracy/linear_error.h"
#include "study/accuracy/point_samples.h"

namespace flatray::coverage_choice {
namespace {

constexpr std::array kTruthSides = {16, 12, 8, 6, 4};  // of a grid of samples

std::function<Outcome()> judged(const std::shared_ptr<DrawnFrame>& film) {
  return [film] {
    Outcome outcome{rms_difference(film->drawn.pixels, film->truth.pixels), 0,
                    developed(film->drawn)};
    outcome.difference =
        difference_image(*outcome.picture, developed(film->truth), kDifferenceGain);
    return outcome;
  };
}

std::vector<SamplePlace> grid(int side) {
  std::vector<SamplePlace> places;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) places.push_back({(x + 0.5) / side, (y + 0.5) / side});
  return places;
}

// Each pixel by the mean of side * side samples on a grid.
Setting samples(const std::shared_ptr<DrawnFrame>& film, int side) {
  const std::string words =
      side == 1 ? "pixel centres" : fmt::format("{} samples a pixel", side * side);
  return {words, static_cast<double>(side * side),
          [film, side] { film->drawn = mean_light(film->list, grid(side), film->threads); },
          judged(film)};
}

// What GL makes of it, or why there is none.
void add_gl(ChoiceSettings& made, const std::shared_ptr<DrawnFrame>& film) {
  const Backend* backend = entry_named(backends(), "gl");
  if (backend == nullptr) {
    made.missing.push_back({"--backend gl", "this build has none"});
    return;
  }
  for (const unsigned count : {4U, 16U}) {
    const std::string words = fmt::format("--backend gl --samples {}", count);
    auto opened = backend->open({film->threads, count});
    const Result<void> drawn = opened.and_then([&](const auto& gl) {
      return gl->draw(film->list, {std::nullopt, film->threads}, film->drawn);
    });
    if (!drawn) {
      made.missing.push_back({words, drawn.error().front().message});
      continue;
    }
    const std::shared_ptr<Renderer> gl = std::move(*opened);
    const auto work = [film, gl] {
      FLATRAY_CHECK(gl->draw(film->list, {std::nullopt, film->threads}, film->drawn));
    };
    made.settings.push_back({words, 0, work, judged(film),
                             RenderOptions{{"backend", "gl"}, {"samples", std::to_string(count)}}});
  }
}

Setting rays(const std::shared_ptr<DrawnFrame>& film, int rows) {
  const auto list = std::make_shared<DrawList>(film->list);
  list->coverage = Coverage::rows;
  list->rows = rows;
  return {fmt::format("{} rays a row", rows), 0,
          [film, list] {
            film->drawn = render_linear(*list, {std::nullopt, film->threads});
          },
          judged(film),
          RenderOptions{{"define", "film.coverage=\"rows\""},
                        {"define", fmt::format("film.rows={}", rows)}}};
}

// The mean of side * side samples, as many as there is time for; doubt is by how much a coarser
// grid is off. One of half the side would see level and upright edges where the finer one does.
struct Truth {
  int side;
  double doubt;
};
int coarser(int side) { return side / 2 - 1; }
Truth find_truth(DrawnFrame& film, double seconds) {
  const double start = processor_seconds();
  film.truth = mean_light(film.list, grid(1), film.threads);
  const double one = std::max(processor_seconds() - start, 1e-6);
  const auto* side = kTruthSides.begin();
  while (side + 1 != kTruthSides.end() && 1.25 * *side * *side * one > seconds) ++side;
  film.truth = mean_light(film.list, grid(*side), film.threads);
  const LinearImage rough = mean_light(film.list, grid(coarser(*side)), film.threads);
  return {*side, rms_difference(film.truth.pixels, rough.pixels)};
}

std::string left_out(const Scene& scene) {
  return scene.film.coverage == Coverage::centre ? "the scene asks for pixel centres" : "";
}

Result<ChoiceSettings> settings(const AccuracyContext& context) {
  FLATRAY_TRY(frame, frame_to_draw(context));
  const std::shared_ptr<DrawnFrame>& film = *frame;
  const auto [side, doubt] = find_truth(*film, reference_budget(context));
  ChoiceSettings made;
  made.unit = "root mean square of linear light, 1 is white";
  made.reference =
      fmt::format("frame {} by {} samples a pixel, from which {} differ by {:.2g}",
                  middle_frame(context.scene), side * side, coarser(side) * coarser(side), doubt);
  if (side < kTruthSides.front())
    made.cut = fmt::format("reference of {} samples a pixel instead of {}", side * side,
                           kTruthSides.front() * kTruthSides.front());
  made.doubt = doubt;
  made.grows = "samples a pixel";
  made.settings = {samples(film, 1),
                   {"exact area", 0,
                    [film] {
                      film->drawn = render_linear(film->list, {std::nullopt, film->threads});
                    },
                    judged(film), RenderOptions{}},
                   rays(film, 4),
                   rays(film, 16)};
  made.settings.front().options = RenderOptions{{"define", "film.coverage=\"centre\""}};
  for (const int n : {2, 4, 8})
    if (2 * n <= side)
      made.settings.push_back(samples(film, n));
    else
      made.cut += fmt::format(", {} samples a pixel", n * n);
  add_gl(made, film);
  return made;
}

}  // namespace

extern const Choice entry = {"coverage",
                             "What does it cost to know how much of a pixel a thing covers?",
                             ErrorKind::discretisation, &left_out, &settings};

}  // namespace flatray::coverage_choice
