#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/counted.h"
#include "base/number_text.h"
#include "base/portable_math.h"
#include "base/table.h"
#include "study/experiment.h"
#include "study/plots/state_graph.h"
#include "study/statistics/absorption.h"
#include "study/statistics/chain_walks.h"

namespace flatray::markov_experiment {
namespace {

constexpr double kRunsAFalseAlarm = 10'000;  // of draws that are right
constexpr std::size_t kMostStates = 64;  // solved exactly: half a minute where rows have 17 digits
constexpr std::size_t kLongestFraction = 100;     // shown; longer ones are given as decimals only
constexpr std::uint64_t kMostSteps = 1ULL << 32;  // walked for one chain and start
constexpr double kLongestMean = 0x1p24;           // of walks that are observed at all
// From any state a walk is over within twice the largest mean with odds of at least 1/2 (Markov's
// inequality), so after 256 means it goes on with odds below 2^-128.
constexpr double kMeansUntilGivenUp = 256;

// How many observations a chain gives: each start, and each way out of a state that has several.
std::size_t observations(const MarkovChain& chain) {
  std::size_t count = 0;
  for (StateId from = 0; from < chain.rows.size(); ++from) {
    const std::vector<Transition>& row = chain.rows[from];
    if (row.size() > 1 || row[0].to != from) ++count;
    if (row.size() > 1) count += row.size();
  }
  return count;
}

// Standard errors by which one of `count` observations may miss what is expected: normal numbers lie
// beyond k with odds below exp(-k^2 / 2).
double allowed_sigmas(std::size_t count) {
  return std::sqrt(2 * portable::log(kRunsAFalseAlarm * static_cast<double>(count)));
}

double z_score(double difference, double standard_error) {
  return difference == 0 ? 0 : difference / standard_error;
}

class Study {
 public:
  explicit Study(const ExperimentContext& context) : context_(context) {
    for (const MarkovChain& chain : context.scene.chains) observations_ += observations(chain);
    sigmas_ = allowed_sigmas(std::max<std::size_t>(observations_, 1));
  }

  void add(std::uint32_t index) {
    const MarkovChain& chain = context_.scene.chains[index];
    const StepMatrix drawn = drawn_probabilities(chain);
    const StepMatrix given = given_probabilities(chain).value_or(drawn);
    add_transitions(chain, add_starts(index, given, drawn), given);
    result_.files.push_back(
        {fmt::format("markov_{}.svg", chain.name), svg(drawing_of(graph(chain, given)))});
  }

  ExperimentResult result() && {
    result_.holds = disagreements_ + not_walked_ == 0;  // it has not been shown to agree
    result_.files.push_back(csv_file("markov", starts_));
    result_.files.push_back(csv_file("markov_transitions", transitions_));
    Fields fields = head_of("markov", context_);
    fields.insert(fields.end(), {{"largest_z", worst_},
                                 {"disagreements", disagreements_},
                                 {"not_observed", not_walked_},
                                 {"starts", starts_},
                                 {"transitions", transitions_}});
    result_.files.push_back(json_file("markov", fields));
    result_.summary = summary();
    return std::move(result_);
  }

 private:
  // What a table of starts is made of: the closed form of the probabilities given, and of those
  // that 64-bit draws can have.
  struct Truth {
    std::optional<Absorption> given, drawn;
    double expected() const { return given ? given->expected.nearest() : kInfinity; }
    Values cells(const WalkPlan& plan) const {
      return {
          plan.chain.name,
          plan.chain.states[plan.start],
          absorbing_names(plan),
          given && given->expected.text().size() <= kLongestFraction ? given->expected.text() : "",
          expected(),
          drawn ? drawn->expected.nearest() : kInfinity};
    }
  };

  // Returns what all its walks took together.
  WalkCounts add_starts(std::uint32_t index, const StepMatrix& given, const StepMatrix& drawn) {
    const MarkovChain& chain = context_.scene.chains[index];
    const std::vector<bool> absorbing = absorbing_states(given);
    const auto truth = steps_to_absorption(given, absorbing),
               table = steps_to_absorption(drawn, absorbing);
    double longest = 0;
    for (const std::optional<Absorption>& from : truth)
      if (from) longest = std::max(longest, from->expected.nearest());
    const auto limit =
        static_cast<std::uint64_t>(kMeansUntilGivenUp * std::min(longest, kLongestMean));
    WalkCounts all(chain);
    for (StateId start = 0; start < given.size(); ++start) {
      if (absorbing[start]) continue;
      const WalkPlan plan = {chain, start,         absorbing,           walks(longest),
                             limit, context_.seed, (index << 8) | start};
      add_start(plan, {truth[start], table[start]}, longest, all);
    }
    return all;
  }

  std::uint64_t walks(double longest) const {
    if (longest > kLongestMean) return 0;
    return std::min(context_.count, kMostSteps / static_cast<std::uint64_t>(longest + 1));
  }

  void add_start(const WalkPlan& plan, const Truth& truth, double longest, WalkCounts& all) {
    Values row = truth.cells(plan);
    if (!truth.given || plan.walks == 0) {
      if (truth.given) ++not_walked_;
      row.insert(row.end(), {"", "", "", "", std::uint64_t{0},
                             truth.given ? "too many to observe" : "absorption is not certain"});
    } else {
      const WalkCounts counts = walk(plan, context_.threads);
      const auto walks = static_cast<double>(plan.walks);
      const double mean = static_cast<double>(counts.steps) / walks;
      const double difference = mean - truth.expected();
      const double error = std::sqrt(truth.given->variance.nearest() / walks);
      const double z = z_score(difference, error);
      // A walk goes on for twice the longest mean with odds of a half at most.
      const double allowed = allowed_z(truth.given->variance.nearest() * walks, 3 * longest);
      row.insert(row.end(),
                 {mean, difference, error, z, plan.walks, verdict(z, allowed, counts.unfinished)});
      all += counts;
    }
    starts_.add(std::move(row));
  }

  // The same of a sum of that variance: more where hardly ever something is added, of a size of `one`
  // (Bernstein's inequality).
  double allowed_z(double variance, double one) const {
    if (variance == 0) return sigmas_;
    const double rare = sigmas_ * sigmas_ / 6 * one;
    return (rare + std::sqrt(rare * rare + sigmas_ * sigmas_ * variance)) / std::sqrt(variance);
  }

  static std::string absorbing_names(const WalkPlan& plan) {
    std::string names;
    for (std::size_t i = 0; i < plan.absorbing.size(); ++i)
      if (plan.absorbing[i]) names += (names.empty() ? "" : " or ") + plan.chain.states[i];
    return names.empty() ? "nothing" : names;
  }

  std::string verdict(double z, double allowed, std::uint64_t unfinished) {
    worst_ = std::max(worst_, std::fabs(z));
    const bool agrees = std::fabs(z) <= allowed && unfinished == 0;
    if (!agrees) ++disagreements_;
    return unfinished > 0 ? fmt::format("no: {} walks given up", unfinished)
           : agrees       ? "yes"
                          : "no";
  }

  void add_transitions(const MarkovChain& chain, const WalkCounts& counts,
                       const StepMatrix& given) {
    for (std::size_t i = 0; i < given.size(); ++i) {
      std::uint64_t visits = 0;
      for (const std::uint64_t count : counts.transitions[i]) visits += count;
      for (std::size_t j = 0; visits > 0 && j < given.size(); ++j) {
        const double probability = given[i][j].nearest(), n = static_cast<double>(visits);
        const std::uint64_t count = counts.transitions[i][j];
        if (probability == 0 && count == 0) continue;
        const double variance = n * probability * (1 - probability);
        const double z = z_score(static_cast<double>(count) - n * probability, std::sqrt(variance));
        transitions_.add({chain.name, chain.states[i], chain.states[j], label(given[i][j]),
                          probability, static_cast<double>(count) / n, visits, z,
                          verdict(z, allowed_z(variance, 1), 0)});
      }
    }
  }

  // A short decimal where there is one, else a short fraction, else six digits.
  static std::string label(const Rational& probability) {
    std::string decimal = number_text(probability.nearest()), fraction = probability.text();
    if (decimal.size() <= 6) return decimal;
    return fraction.size() <= 11 ? fraction : fmt::format("{:.6g}", probability.nearest());
  }

  static StateGraph graph(const MarkovChain& chain, const StepMatrix& shown) {
    StateGraph graph{"States of chain " + chain.name, chain.states, {}};
    for (std::size_t i = 0; i < shown.size(); ++i)
      for (std::size_t j = 0; j < shown.size(); ++j)
        if (shown[i][j].sign() != Sign::zero) graph.arrows.push_back({i, j, label(shown[i][j])});
    return graph;
  }

  std::string summary() const {
    return fmt::format(
        "Steps to an absorbing state, {} walks from each start, seed {}\n\n{}\n"
        "Transitions taken, all starts together\n\n{}\n{}: largest |z| {:.3g}, {:.3g} allowed of "
        "{}, more of steps hardly ever taken{}\n",
        context_.count, context_.seed, aligned_text(starts_, kBrief),
        aligned_text(transitions_, kBrief),
        disagreements_ > 0 ? "DISAGREES with the closed form"
        : not_walked_ > 0  ? "not all shown to agree with the closed form"
                           : "agrees with the closed form",
        worst_, sigmas_, counted(observations_, "observation"),
        not_walked_ == 0 ? ""
                         : fmt::format("; {} not observed, as the mean is beyond {:.0f} steps",
                                       counted(not_walked_, "start"), kLongestMean));
  }

  const ExperimentContext& context_;
  Table starts_{{"chain", "start", "until", "exact", "expected", "drawn", "observed", "difference",
                 "standard_error", "z", "walks", "agrees"}};
  Table transitions_{
      {"chain", "from", "to", "given", "probability", "observed", "visits", "z", "agrees"}};
  std::size_t observations_ = 0;
  double sigmas_ = 0;  // that may lie between one of them and what is expected
  double worst_ = 0;
  std::uint64_t disagreements_ = 0, not_walked_ = 0;
  ExperimentResult result_;
};

Result<ExperimentResult> run(const ExperimentContext& context) {
  const Place place = context.scene.where;
  if (context.scene.chains.empty())
    return fail(place, "has no Markov chain", "give it a table [markov.NAME]");
  if (context.count < 1 || context.count > kMostSteps)
    return refused_option("--count", fmt::format("{} walks cannot be made", context.count),
                          "say 1 to 4294967296");
  for (const MarkovChain& chain : context.scene.chains)
    if (chain.rows.size() > kMostStates)
      return fail(place, fmt::format("chain {} has {} states", chain.name, chain.rows.size()),
                  fmt::format("up to {} are solved exactly", kMostStates));
  Study study(context);
  for (std::uint32_t i = 0; i < context.scene.chains.size(); ++i) study.add(i);
  return std::move(study).result();
}

}  // namespace

extern const Experiment entry = {
    "markov",
    "How many steps does each chain take to its end, and do its draws keep to it?",
    &run,
    {.count = true, .seed = true}};

}  // namespace flatray::markov_experiment
