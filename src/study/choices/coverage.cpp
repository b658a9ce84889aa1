#include <fmt/core.h>

#include <array>

#include "base/entry_named.h"
#include "base/processor_time.h"
#include "image/compare.h"
#include "image/hdr.h"
#include "render/backend.h"
#include "study/accuracy/linear_error.h"
#include "study/accuracy/point_samples.h"

namespace flatray::coverage_choice {
namespace {

constexpr std::array kTruthSamples = {256, 128, 64, 32, 16};

std::function<Outcome()> judged(const std::shared_ptr<DrawnFrame>& film) {
  return [film] {
    Outcome outcome{rms_difference(film->drawn.pixels, film->truth.pixels), 0,
                    develop(film->drawn)};
    outcome.difference = difference_image(*outcome.picture, develop(film->truth), kDifferenceGain);
    return outcome;
  };
}

std::vector<SamplePlace> grid(int side) {
  std::vector<SamplePlace> places;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) places.push_back({(x + 0.5) / side, (y + 0.5) / side});
  return places;
}

// A power of two of samples on a lattice, no two of them in one row or column: level and upright
// edges, too, are seen to within half of 1 / count of a pixel. The factor is about count times the
// golden section, and odd, so that it meets every row.
std::vector<SamplePlace> lattice(int count) {
  const int factor = count * 618 / 1000 | 1;
  std::vector<SamplePlace> places;
  for (int i = 0; i < count; ++i)
    places.push_back({(i + 0.5) / count, (i * factor % count + 0.5) / count});
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
    if (!opened) {
      made.missing.push_back({words, opened.error().front().message});
      continue;
    }
    const std::shared_ptr<Renderer> gl = std::move(*opened);
    const auto drawn = std::make_shared<Result<void>>();
    const auto work = [film, gl, drawn] {
      *drawn = gl->draw(film->list, {std::nullopt, film->threads}, film->drawn);
    };
    const auto judge = [drawn, of_drawn = judged(film)]() -> Result<Outcome> {
      if (!*drawn) return tl::unexpected(drawn->error());
      return of_drawn();
    };
    made.settings.push_back({words, 0, work, judge,
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

// The mean of as many samples as there is time for; doubt is by how much fewer are off, but no less
// than what edges along the rows or columns of samples may be off unseen.
struct Truth {
  int count;
  double doubt;
};
int coarser(int count) { return count / 4; }
Truth find_truth(DrawnFrame& film, double seconds) {
  const double start = processor_seconds();
  film.truth = mean_light(film.list, lattice(1), film.threads);
  const double one = std::max(processor_seconds() - start, 1e-6);
  const auto* count = kTruthSamples.begin();
  while (count + 1 != kTruthSamples.end() && 1.25 * *count * one > seconds) ++count;
  film.truth = mean_light(film.list, lattice(*count), film.threads);
  const LinearImage rough = mean_light(film.list, lattice(coarser(*count)), film.threads);
  const std::vector<bool> edges = edge_pixels(film.list);
  const double share =
      static_cast<double>(std::ranges::count(edges, true)) / static_cast<double>(edges.size());
  return {*count, std::max(rms_difference(film.truth.pixels, rough.pixels),
                           0.5 / *count * std::sqrt(share))};
}

std::string left_out(const Scene& scene) {
  return scene.film.coverage == Coverage::centre ? "the scene asks for pixel centres" : "";
}

Result<ChoiceSettings> settings(const AccuracyContext& context) {
  FLATRAY_TRY(frame, frame_to_draw(context));
  const std::shared_ptr<DrawnFrame>& film = *frame;
  const auto [count, doubt] = find_truth(*film, reference_budget(context));
  ChoiceSettings made;
  made.unit = "root mean square of linear light, 1 is white";
  made.reference = fmt::format("frame {} by {} samples a pixel, from which {} differ by {:.2g}",
                               middle_frame(context.scene), count, coarser(count), doubt);
  if (count < kTruthSamples.front())
    made.cut =
        fmt::format("reference of {} samples a pixel instead of {}", count, kTruthSamples.front());
  made.doubt = doubt;
  made.grows = "samples a pixel";
  made.settings = {samples(film, 1),
                   {"exact area", 0,
                    [film] {
                      film->drawn = render_linear(film->list, {std::nullopt, film->threads});
                    },
                    judged(film), RenderOptions{{"define", "film.coverage=\"area\""}}},
                   rays(film, 4),
                   rays(film, 16)};
  made.settings.front().options = RenderOptions{{"define", "film.coverage=\"centre\""}};
  for (const int n : {2, 4, 8})
    if (4 * n * n <= count)
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
