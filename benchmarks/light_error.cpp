// How does the error of light fall with its rays? Root mean squares over all pixels, between independent seeds, divided by
// the mean, of samplers and estimators; slopes of log error against log rays; and error times the root of seconds.
//
//   light_error [SCENE...]   of scenes beside a point lamp in the open and a matt room, at 160 by 90 pixels
#include <fmt/core.h>

#include <cmath>

#include "measure.h"
#include "render/light/light_picture.h"
#include "render/light/light_run.h"
#include "scene/lamp.h"
#include "scene/load.h"

namespace {

using namespace flatray;

constexpr unsigned kSeeds = 6;
constexpr unsigned kFirst = 12, kLast = 20;  // powers of two of rays

constexpr const char* kPoint =
    "flatray = 1\nfilm = { size = [160, 90], world = [[-8, -4.5], [8, 4.5]] }\n"
    "[[lamp]]\nsource = { point = {} }\nat = [0.013, 0.037]\n";
constexpr const char* kRoom =
    "flatray = 1\nfilm = { size = [160, 90], world = [[-8, -4.5], [8, 4.5]] }\n"
    "[[lamp]]\nsource = { point = {} }\nat = [0.013, 0.037]\n"
    "[[chamber]]\nshape = { box = { min = [-7.9, -4.4], max = [7.9, 4.4] } }\n"
    "material = { diffuse = { reflectance = 0.7 } }\n";

struct Way {
  const char* name;
  LightSampler sampler;
  LightEstimator estimator;
};
constexpr Way kWays[] = {{"random", LightSampler::random, LightEstimator::forward},
                         {"sorted", LightSampler::sorted, LightEstimator::forward},
                         {"backward", LightSampler::sorted, LightEstimator::backward}};

std::vector<double> fluence(const Scene& scene, std::uint64_t seed) {
  const FrameState state = at(Timeline(scene, seed, 1), 1);
  return frame_fluence(scene, state, nullptr, seed, {1, nullptr, true});
}

// Standard deviation of a pixel, over the mean.
double relative_error(const std::vector<std::vector<double>>& pictures) {
  double variance = 0, mean = 0;
  const std::size_t numbers = pictures.front().size();
  for (std::size_t i = 0; i < numbers; ++i) {
    double sum = 0, squares = 0;
    for (const auto& one : pictures) sum += one[i];
    const double middle = sum / static_cast<double>(pictures.size());
    for (const auto& one : pictures) squares += (one[i] - middle) * (one[i] - middle);
    variance += squares / static_cast<double>(pictures.size() - 1), mean += middle;
  }
  const auto all = static_cast<double>(numbers);
  return std::sqrt(variance / all) / (mean / all);
}

// Slope of a line through points a step of two apart in log2 of rays, and its standard error.
std::array<double, 2> slope(const std::vector<double>& errors) {
  const auto n = static_cast<double>(errors.size());
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0, left = 0;
  for (std::size_t i = 0; i < errors.size(); ++i)
    mean_x += 2 * static_cast<double>(i) / n, mean_y += std::log2(errors[i]) / n;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double x = 2 * static_cast<double>(i) - mean_x;
    xx += x * x, xy += x * (std::log2(errors[i]) - mean_y);
  }
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double off =
        std::log2(errors[i]) - mean_y - xy / xx * (2 * static_cast<double>(i) - mean_x);
    left += off * off;
  }
  return {xy / xx, std::sqrt(left / (n - 2) / xx)};
}

void study(const std::string& name, Scene scene) {
  scene.film.width = 160, scene.film.height = 90;
  fmt::print("\n{}\n{:>10}", name, "rays");
  for (unsigned power = kFirst; power <= kLast; power += 2) fmt::print("{:>10}", 1U << power);
  fmt::print("{:>18}{:>14}\n", "slope", "error x s^1/2");
  for (const Way& way : kWays) {
    if (way.estimator == LightEstimator::backward && why_not_backward(scene)) continue;
    scene.light.sampler = way.sampler, scene.light.estimator = way.estimator;
    std::vector<double> errors;
    double seconds = 0;
    fmt::print("{:>10}", way.name);
    // Fewer paths than backward has at least tell nothing new.
    const unsigned first = way.estimator == LightEstimator::backward ? 18 : kFirst;
    for (unsigned power = kFirst; power <= kLast; power += 2) {
      if (power < first) {
        fmt::print("{:>10}", "");
        continue;
      }
      scene.light.rays = std::uint64_t{1} << power;
      std::vector<std::vector<double>> pictures;
      const double start = bench::seconds(CLOCK_PROCESS_CPUTIME_ID);
      for (unsigned seed = 0; seed < kSeeds; ++seed) pictures.push_back(fluence(scene, seed));
      seconds = (bench::seconds(CLOCK_PROCESS_CPUTIME_ID) - start) / kSeeds;
      errors.push_back(relative_error(pictures));
      fmt::print("{:>10.2e}", errors.back());
      std::fflush(stdout);
    }
    const auto [fall, doubt] = slope(errors);
    const std::string fitted =
        errors.size() < 3 ? "" : fmt::format("{:.2f} +- {:.2f}", fall, doubt);
    fmt::print("{:>18}{:>14.2e}\n", fitted, errors.back() * std::sqrt(seconds));
  }
}

}  // namespace

int main(int argc, char** argv) {
  study("point lamp in the open", load_scene_text("point.toml", kPoint, {})->scene);
  study("matt room", load_scene_text("room.toml", kRoom, {})->scene);
  for (int i = 1; i < argc; ++i) {
    Result<LoadedScene> loaded = load_scene(argv[i], {}, {});
    if (!loaded) {
      fmt::print(stderr, "{}", format(loaded.error()));
      return 1;
    }
    study(argv[i], std::move(loaded->scene));
  }
}
