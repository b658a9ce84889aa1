#include "app/options/light_wish.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "app/frames/render_job.h"
#include "app/options/option_values.h"
#include "base/number_text.h"
#include "scene/lamp.h"

namespace flatray {
namespace {

constexpr std::uint64_t kMostRays = FilmRounds::kMost * kLightRound;

Result<double> parse_error(const std::string& text, const Place& where) {
  const auto error = parse_number(text);
  if (error && *error > 0) return *error;
  return usage_error(where, "is not a number above 0",
                     "say 0.01 for a picture within one part in a hundred");
}

Result<void> fits_scene(const Arguments& arguments, const RenderJob& job) {
  const bool film = job.output.format().of_film != nullptr;
  const bool no_light = !job.has_light();
  if (no_light)
    for (const char* option : {"error", "time"})
      if (arguments.has(option) && !arguments.has("profile"))
        return usage_error(arguments.where(option), "needs --profile, or lamps in the scene",
                           "flatray accuracy SCENE --profile FILE writes one");
  if (no_light && (film || job.light.any()))
    return usage_error(arguments.where(film                    ? "output"
                                       : job.light.rays        ? "rays"
                                       : job.light.estimator   ? "estimator"
                                       : job.light.error_image ? "error-image"
                                                               : "ray-shard"),
                       job.view ? "is of light, which --view does not show"
                                : "is of light, and the scene has no lamp",
                       job.view ? "leave one of them out" : "add [[lamp]] source = { point = {} }");
  if (film && job.crop)
    return usage_error(arguments.where("crop"), "does not go with a film", "leave it out");
  if (job.light.resume && !no_light && !film && !job.output.has_frame())
    return usage_error(arguments.where("resume"), "has no film to go on from: a picture keeps none",
                       "say -o light.film --resume, then flatray merge light.film -o picture.png");
  if (!film && job.light.shard.count > 1)
    return usage_error(arguments.where("ray-shard"), "needs a film to be added to the others",
                       "say -o part.film, then flatray merge");
  return {};
}

Result<void> fits_error_image(const Arguments& arguments, const RenderJob& job) {
  if (!job.light.error_image) return {};
  const auto wrong = [&](const char* what, const char* hint) {
    return usage_error(arguments.where("error-image"), what, hint);
  };
  const OutputPattern& image = *job.light.error_image;
  if (image.is_stdout() || job.output.is_stdout())
    return wrong("does not go with standard output", "name files for both");
  if (job.output.format().is_video())
    return wrong("does not go with a video", "write frame_####.png");
  if (image.format().of_film != nullptr || image.format().is_video())
    return wrong("is a picture, not a film or a video", "say .pfm, .hdr or .png");
  if (image.has_frame() != job.output.has_frame() || image.has_scene() != job.output.has_scene())
    return wrong("does not have the places for numbers and names that -o has",
                 "write both alike, as out/####.png and out/error_####.pfm");
  std::set<std::filesystem::path> pictures;
  for (const unsigned frame : job.frames) pictures.insert(job.path(frame));
  if (std::ranges::any_of(job.frames, [&](unsigned frame) {
        return pictures.contains(image.path(job.name, frame));
      }))
    return wrong("is where a picture goes", "name another file");
  return {};
}

}  // namespace

void LightWish::rows(OptionTable& row) {
  constexpr Word<LightEstimator> kEstimators[] = {{"forward", LightEstimator::forward},
                                                  {"backward", LightEstimator::backward},
                                                  {"auto", LightEstimator::automatic}};
  row("--rays N", "rays of all lamps of a frame, instead of the scene's", rays, 1, kMostRays);
  row("--estimator", "how light is followed, instead of the scene's", estimator, kEstimators);
  row("--ray-shard I/N", "into a film: only every N-th round of rays, from the I-th on", shard,
      &parse_shard);
  row(kErrorImageRow);
  row.read("error-image", error_image, [](const std::string& text, const Place& where) {
    return OutputPattern::parse(text, std::nullopt, where);
  });
}

void LightWish::read_ends(OptionTable& row) {
  row.read("error", error, &parse_error);
  row.read("time", seconds, time_up_to(kInfinity));
}

Result<void> wish_light(const Arguments& arguments, const LightWish& wish, RenderJob& job) {
  job.light = wish;
  if (auto fits = fits_scene(arguments, job); !fits) return fits;
  if (auto fits = fits_error_image(arguments, job); !fits) return fits;
  LightSettings& light = job.scene.light;
  if (wish.estimator) light.estimator = *wish.estimator;
  if (light.estimator == LightEstimator::backward)
    if (auto hindrance = why_not_backward(job.scene))
      return tl::unexpected(Diagnostics{std::move(*hindrance)});
  if (wish.rays)
    light.rays = *wish.rays;
  else if (wish.seconds < kInfinity || wish.error > 0)
    light.rays = kMostRays;
  const bool film = job.output.format().of_film != nullptr;
  if (film) light.rays = rounds_of(light.rays) * kLightRound;
  const char* by_rounds = film                       ? "a film"
                          : wish.error > 0           ? "--error"
                          : wish.seconds < kInfinity ? "--time"
                          : wish.error_image         ? "--error-image"
                          : light.scrambles > 1      ? "light.scrambles"
                                                     : nullptr;
  if (by_rounds != nullptr && light.estimator == LightEstimator::backward)
    return usage_error(
        wish.estimator ? arguments.where("estimator") : light.where,
        fmt::format("backward has no rounds of rays, which {} is made of", by_rounds),
        fmt::format("say --estimator forward, or leave {} out", by_rounds));
  if (by_rounds != nullptr) light.estimator = LightEstimator::forward;
  if (wish.error > 0 || wish.error_image)
    light.scrambles = std::max(light.scrambles, kScrambles[0]);
  return {};
}

}  // namespace flatray
