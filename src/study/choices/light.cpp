#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include "base/processor_time.h"
#include "image/compare.h"
#include "image/srgb.h"
#include "render/light/light_picture.h"
#include "render/light/light_run.h"
#include "scene/lamp.h"
#include "study/accuracy/linear_error.h"
#include "study/rooms/pixel_map.h"
#include "study/statistics/estimate.h"

namespace flatray::light_choice {
namespace {

constexpr int kSide = 128;           // pixels of the longer side of the film
constexpr std::uint64_t kSeeds = 4;  // pictures of a setting
constexpr std::uint64_t kLeastRays = 4096, kMostRays = std::uint64_t{1} << 20,
                        kTruthRays = std::uint64_t{1} << 18;

struct Way {
  const char* series;
  LightEstimator estimator;
  LightSampler sampler;
};
constexpr Way kWays[] = {{"forward, sorted", LightEstimator::forward, LightSampler::sorted},
                         {"forward, random", LightEstimator::forward, LightSampler::random},
                         {"backward", LightEstimator::backward, LightSampler::sorted}};

using Fluence = std::vector<double>;

// The light of a frame on a small film, what it is, and what a setting found in its pictures.
struct Lit {
  Scene scene;
  FrameState state;
  std::uint64_t seed;
  unsigned threads;
  Fluence truth;
  std::vector<Fluence> found;

  // Under a seed of its own.
  Fluence picture(const Way& way, std::uint64_t rays, std::uint64_t number) {
    scene.light.estimator = way.estimator, scene.light.sampler = way.sampler;
    scene.light.rays = rays;
    return frame_fluence(scene, state, nullptr, seed + number, {threads, nullptr, true});
  }
};

double mean(const Fluence& light) {
  return std::accumulate(light.begin(), light.end(), 0.0) / static_cast<double>(light.size());
}

// Root mean square over the pictures; its doubt by how they differ.
Outcome judge(const Lit& lit) {
  const double scale = 1 / mean(lit.truth);
  double squares = 0, sum = 0;
  for (const Fluence& one : lit.found) {
    const double error = scale * rms_difference(one, lit.truth);
    squares += error * error, sum += error;
  }
  const double variance = std::max(squares - sum * sum / kSeeds, 0.0) / (kSeeds - 1);
  const auto image_of = [&](const Fluence& light) {
    const LightPicture shown = light_picture(light, 1, lit.scene.light, false);
    Image image(lit.scene.film.width, lit.scene.film.height, 3);
    for (std::size_t i = 0; i < shown.rgb.size(); ++i)
      image.pixels[i] = srgb_from_linear(std::min(shown.rgb[i], 1.0F));
    return image;
  };
  Outcome outcome{std::sqrt(squares / kSeeds),
                  student_95(kSeeds - 1) * std::sqrt(variance / kSeeds),
                  image_of(lit.found.front())};
  outcome.difference = difference_image(*outcome.picture, image_of(lit.truth), kDifferenceGain);
  return outcome;
}

// The mean of as many pictures as there is time for, of fewer rays where kSeeds are too many, and
// what it is off itself.
struct Truth {
  std::uint64_t rays;
  std::size_t pictures;
  double doubt;
};
Truth find_truth(Lit& lit, double seconds) {
  const double start = processor_seconds();
  lit.picture(kWays[0], kLeastRays, kSeeds);
  const double least = processor_seconds() - start;
  std::uint64_t rays = kTruthRays;
  while (rays > kLeastRays && least * static_cast<double>(kSeeds * rays / kLeastRays) > seconds)
    rays /= 4;
  std::vector<Fluence> pictures;
  while (pictures.size() < kSeeds || processor_seconds() - start < seconds)
    pictures.push_back(lit.picture(kWays[0], rays, kSeeds + pictures.size()));
  const auto count = static_cast<double>(pictures.size());
  lit.truth.assign(pictures.front().size(), 0.0);
  for (const Fluence& one : pictures)
    for (std::size_t i = 0; i < one.size(); ++i) lit.truth[i] += one[i] / count;
  double squares = 0;
  for (const Fluence& one : pictures) {
    const double off = rms_difference(one, lit.truth);
    squares += off * off;
  }
  return {rays, pictures.size(), std::sqrt(squares / (count * (count - 1))) / mean(lit.truth)};
}

Setting followed(const std::shared_ptr<Lit>& lit, const Way& way, std::uint64_t rays) {
  Setting setting;
  setting.words = fmt::format("{}, {} rays", way.series, rays);
  setting.n = static_cast<double>(rays);
  setting.work = [lit, way, rays] {
    lit->found.clear();
    for (std::uint64_t k = 0; k < kSeeds; ++k) lit->found.push_back(lit->picture(way, rays, k));
  };
  setting.judge = [lit] { return judge(*lit); };
  setting.series = way.series;
  return setting;
}

std::string left_out(const Scene& scene) {
  return scene.lamps.empty() ? "the scene has no lamps" : "";
}

Result<ChoiceSettings> settings(const AccuracyContext& context) {
  const unsigned frame = middle_frame(context.scene);
  const auto lit =
      std::make_shared<Lit>(Lit{context.scene,
                                at(Timeline(context.scene, context.seed, frame), frame),
                                context.seed,
                                context.threads,
                                {},
                                {}});
  Film& film = lit->scene.film;
  shrink(film, kSide);
  const auto [rays_of_truth, pictures, doubt] = find_truth(*lit, reference_budget(context));
  if (!(mean(lit->truth) > 0))
    return fail(context.scene.lamps.front().where, "no light reaches the picture");
  ChoiceSettings made;
  made.unit = fmt::format("root mean square over the pixels of a film of {}x{}, over the mean",
                          film.width, film.height);
  made.reference =
      fmt::format("frame {}, the mean of {} pictures of {} rays, which is off by {:.2g}", frame,
                  pictures, rays_of_truth, doubt);
  if (rays_of_truth < kTruthRays)
    made.cut = fmt::format("reference of {} rays instead of {}", rays_of_truth, kTruthRays);
  made.doubt = doubt;
  made.grows = "rays";
  const std::uint64_t pixels = pixel_count(film);
  for (std::uint64_t rays = kLeastRays; rays <= kMostRays; rays *= 4)
    for (const Way& way : kWays) {
      if (way.estimator == LightEstimator::backward &&
          (why_not_backward(lit->scene) || paths_a_pixel(rays, pixels) * pixels > 2 * rays))
        continue;
      made.settings.push_back(followed(lit, way, rays));
    }
  return made;
}

}  // namespace

extern const Choice entry = {"light", "How many rays of light, by which sampler and which way?",
                             ErrorKind::sampling, &left_out, &settings};

}  // namespace flatray::light_choice
