#include <fmt/core.h>

#include <cmath>
#include <memory>

#include "base/check.h"
#include "base/entry_named.h"
#include "study/accuracy/accuracy.h"
#include "study/rooms/room.h"
#include "study/statistics/estimate.h"

namespace flatray::samples_choice {
namespace {

constexpr std::uint64_t kSeeds = 16;

// How starts are drawn, and the flights of each orbit: of few the mean is a smooth function of the
// start, of many no sequence of starts is even in all of them.
struct Sampler {
  const char* series;
  Starts starts;
  std::uint64_t flights;
};
constexpr Sampler kSamplers[] = {{"random, 100 flights each", Starts::random, 100},
                                 {"random, 1 flight each", Starts::random, 1},
                                 {"quasi, 1 flight each", Starts::quasi, 1}};

// Mean free paths found under so many seeds.
struct Paths {
  std::vector<double> found;
  double expected = 0;
};

const Experiment* experiment() { return entry_named(experiments(), "mean-free-path"); }

// Root mean square over the seeds.
Outcome judge(const Paths& paths) {
  double sum = 0;
  for (const double path : paths.found) sum += (path - paths.expected) * (path - paths.expected);
  const auto count = static_cast<double>(paths.found.size());
  const double rms = std::sqrt(sum / count);
  return {rms / paths.expected, half_of_rms(count) * rms / paths.expected, {}};
}

std::string left_out(const Scene& scene) {
  if (scene.field() != 0) return kRaysAreBent;
  if (experiment() == nullptr) return "this build has no experiment mean-free-path";
  const auto closed = expect_closed({.scene = scene});
  return closed ? "" : closed.error().front().message;
}

Setting flights(const AccuracyContext& context, std::uint64_t count, const Sampler& sampler) {
  const auto paths = std::make_shared<Paths>();
  const Scene& scene = context.scene;
  const auto work = [paths, count, sampler, &scene, seed = context.seed,
                     threads = context.threads] {
    paths->found.clear();
    for (std::uint64_t k = 0; k < kSeeds; ++k) {
      const auto result = experiment()->run({.scene = scene,
                                             .seed = seed + k,
                                             .count = count,
                                             .threads = threads,
                                             .bounces = sampler.flights,
                                             .starts = sampler.starts});
      FLATRAY_CHECK(result.has_value());  // expect_closed has been asked
      paths->found.push_back(result->measures.front().value);
      paths->expected = result->measures.front().expected.value_or(0);
    }
  };
  return {fmt::format("--count {} --bounces {} --starts {}", count, sampler.flights,
                      sampler.starts == Starts::quasi ? "quasi" : "random"),
          static_cast<double>(count),
          work,
          [paths] { return judge(*paths); },
          std::nullopt,
          sampler.series};
}

Result<ChoiceSettings> settings(const AccuracyContext& context) {
  ChoiceSettings made;
  made.unit = "of the mean free path";
  made.reference = fmt::format("pi A / P (Santalo), over {} seeds", kSeeds);
  made.grows = "flights";
  for (std::uint64_t count = 1000; count <= 1'000'000; count *= 4)
    for (const Sampler& sampler : kSamplers)
      made.settings.push_back(flights(context, count, sampler));
  return made;
}

}  // namespace

extern const Choice entry = {"samples",
                             "What does it cost to know a mean by orbits of drawn starts?",
                             ErrorKind::sampling, &left_out, &settings};

}  // namespace flatray::samples_choice
