#include "app/answers/cost.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/check.h"
#include "base/instruction_count.h"
#include "base/processor_time.h"
#include "study/statistics/median.h"

namespace flatray {
namespace {

constexpr double kSeconds = 1;  // for all rounds
// Of fewer the range of all does not have the confidence: 1 - 2 / 2^8 is the first beyond 0.99.
constexpr std::size_t kFewestRounds = 8, kMostRounds = 20;

std::string spanned(const MedianInterval& value, const char* unit) {
  return fmt::format("{:.3g} {} ({:.3g} to {:.3g})", value.median, unit, value.low, value.high);
}

}  // namespace

Cost cost_of(const std::function<void()>& work) {
  const InstructionCount count;
  const double start = thread_seconds();
  const auto before = count.read();
  work();
  const auto after = count.read();
  Cost cost{thread_seconds() - start, std::nullopt};
  if (before && after) cost.instructions = static_cast<double>(*after - *before);
  return cost;
}

std::size_t rounds_for(double seconds_a_round) {
  const double fit = kSeconds / std::max(seconds_a_round, kSeconds / kMostRounds);
  return std::max(kFewestRounds, static_cast<std::size_t>(fit));
}

std::vector<CostRounds> in_one_unit(const std::vector<std::vector<Cost>>& works) {
  const bool counted = std::ranges::all_of(works, [](const auto& costs) {
    return std::ranges::all_of(costs,
                               [](const Cost& cost) { return cost.instructions.has_value(); });
  });
  std::vector<CostRounds> all;
  for (const std::vector<Cost>& costs : works) {
    CostRounds rounds{{}, counted};
    for (const Cost& cost : costs)
      rounds.values.push_back(counted ? *cost.instructions : cost.seconds);
    all.push_back(std::move(rounds));
  }
  return all;
}

std::string amount_words(const CostRounds& rounds, std::size_t frames) {
  std::vector<double> values = rounds.values;
  for (double& value : values)
    value *= (rounds.instructions ? 1e-6 : 1e3) / static_cast<double>(frames);
  return spanned(median_interval(std::move(values), kConfidence),
                 rounds.instructions ? "million instructions a frame" : "ms a frame");
}

std::string saving_words(const CostRounds& without, const CostRounds& with) {
  FLATRAY_CHECK(without.values.size() == with.values.size());
  std::vector<double> percents;
  for (std::size_t i = 0; i < with.values.size(); ++i)
    percents.push_back(100 * (1 - without.values[i] / with.values[i]));
  const MedianInterval saved = median_interval(std::move(percents), kConfidence);
  const bool known = saved.confidence >= kConfidence && (saved.low > 0 || saved.high < 0);
  if (!known) return "not measurable";
  return saved.high < 0 ? "costs " + spanned({-saved.median, -saved.high, -saved.low}, "%")
                        : spanned(saved, "%");
}

}  // namespace flatray
