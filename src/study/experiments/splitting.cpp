#include "study/rooms/splitting.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "base/portable_math.h"
#include "base/table.h"
#include "study/plots/plot.h"
#include "study/rooms/pixel_map.h"
#include "study/rooms/survival.h"
#include "study/statistics/blocks.h"
#include "study/statistics/estimate.h"

namespace flatray::splitting_experiment {
namespace {

// Of every eight groups the last turns its clones three times as far: what turning changes grows
// with the square.
constexpr std::uint64_t kGroups = 32, kOneIn = 8;
constexpr double kFarther = 3;
constexpr std::uint64_t kPilot = 2000, kFirstBounces = 1000, kPilotBounces = 100'000,
                        kMostLevels = 1000, kLeastOrbits = 100;
constexpr double kLeftAtLevel = 0.25, kLeftAtEnd = 1e-8;
constexpr auto kQuarter = static_cast<std::uint64_t>(kLeftAtLevel * kPilot);
constexpr std::uint64_t kHardlyAny = 200;  // one in so many of those left, while bounces double
constexpr std::uint64_t kForgotten = 3;  // levels before those of a rate, of which nothing is left
constexpr double kWidest = 0.6;  // spread of the groups' shares, beside which intervals still cover

// What a number would be if clones were not turned, from what it is for two angles; as it is,
// without an error, where that is not known, or turning changes it by more than chance: its square
// is then not all of it.
Measure not_turned(Measure near, const Measure& far) {
  constexpr double kShare = 1 / (kFarther * kFarther - 1);
  const double change = kShare * (near.value - far.value);
  const double error = near.standard_error.value_or(kInfinity) * (1 + kShare),
               other = far.standard_error.value_or(kInfinity) * kShare;
  near.standard_error = std::sqrt(error * error + other * other);
  if (std::fabs(change) <= 2 * *near.standard_error && *near.standard_error < kInfinity)
    near.value += change;
  else
    near.standard_error.reset();
  return near;
}

// Bounces of a few orbits that the groups do not use, the most first: so many that three quarters
// are gone, unless hardly any more leave while bounces double, as in a closed part of a room.
Result<std::vector<std::uint64_t>> pilot(const ExperimentContext& context, const Room& room) {
  for (std::uint64_t bounces = kFirstBounces, left = kPilot;;
       bounces = std::min(2 * bounces, kPilotBounces)) {
    FLATRAY_TRY(orbits, trace_pilot(context, room, bounces, kPilot));
    std::vector<std::uint64_t> made;
    for (const PixelOutcome& one : *orbits) made.push_back(one.bounces);
    std::ranges::sort(made, std::greater<>());
    const auto still = static_cast<std::uint64_t>(std::ranges::count(made, bounces));
    const std::uint64_t gone = std::exchange(left, still) - still;
    if (left <= kQuarter) return made;
    if (bounces == kPilotBounces || gone * kHardlyAny < left)
      return fail(context.scene.where,
                  fmt::format("hardly any orbit leaves: {} of {} are still there after {} bounces",
                              left, kPilot, bounces),
                  "splitting is for rooms that orbits leave by holes or gaps");
  }
}

// Levels that leave about a quarter each.
Result<SplittingPlan> plan_of(const ExperimentContext& context, const Room& room) {
  FLATRAY_TRY(made, pilot(context, room));
  const std::uint64_t step = std::max<std::uint64_t>((*made)[kQuarter], 1);
  const auto those = std::ranges::count_if(*made, [&](std::uint64_t one) { return one >= step; });
  const double stay = std::max(static_cast<double>(those) / kPilot, 1.0 / kPilot);
  const auto usual = static_cast<std::uint64_t>(
      std::ceil(portable::log(kLeftAtEnd) / portable::log(std::min(stay, 0.9))));
  const std::uint64_t levels =
      context.bounces ? (*context.bounces + step - 1) / step : std::max<std::uint64_t>(usual, 4);
  const SplittingPlan plan{context.count / (kGroups * levels), levels, step, levels / 3,
                           context.apart};
  if (levels < 4 || levels > kMostLevels)
    return refused_option("--bounces", fmt::format("{} levels of {} bounces", levels, step),
                          fmt::format("ask for {} to {} bounces", 4 * step, kMostLevels * step));
  if (plan.orbits < kLeastOrbits)
    return refused_option(
        "--count", fmt::format("{} orbits a group at each of {} levels", plan.orbits, levels),
        fmt::format("say --count {} or more", kLeastOrbits * kGroups * levels));
  return plan;
}

// By sums of e^(rate way) over what is left at the two levels, weighted; where they are alike is the
// rate.
Measure rate_by_length(const std::vector<SplitGroup>& groups, std::uint64_t first_level) {
  double longest = 0;
  for (const SplitGroup& one : groups)
    for (const double way : one.last) longest = std::max(longest, way);
  const auto weight = [&](const std::vector<double>& ways, double share, double rate) {
    double sum = 0;
    for (const double way : ways) sum += portable::exp(rate * (way - longest));
    return ways.empty() ? 0 : share * sum / static_cast<double>(ways.size());
  };
  const auto difference = [&](const SplitGroup& one, double rate) {
    return weight(one.last, one.share.back(), rate) -
           weight(one.first, one.share[first_level], rate);
  };
  const auto sum = [&](double rate) {
    double all = 0;
    for (const SplitGroup& one : groups) all += difference(one, rate);
    return all;
  };
  Measure found{"escape_rate_per_length", rate_of_zero(sum, longest)};
  constexpr double kStep = 0x1p-20;
  const double slope =
      (sum(found.value * (1 + kStep)) - sum(found.value * (1 - kStep))) / (2 * kStep * found.value);
  RatioSums sums;
  for (const SplitGroup& one : groups) sums.add(difference(one, found.value), 1);
  found.standard_error = sums.standard_error() * sums.samples / std::fabs(slope);
  found.freedom = sums.samples - 1;
  found.widening = sums.widening();
  return found;
}

class Report {
 public:
  Report(const ExperimentContext& context, const SplittingPlan& plan,
         const std::vector<Numbers>& blocks)
      : context_(context), plan_(plan) {
    for (std::size_t i = 0; i < blocks.size(); ++i)
      (is_far(i) ? far_ : near_).push_back(SplitGroup::from(blocks[i]));
  }
  static bool is_far(std::uint64_t group) { return group % kOneIn == kOneIn - 1; }

  ExperimentResult result() const {
    Table table({"bounces", "left", "standard_error"});
    Plot plot{"Orbits that are left, by splitting",
              "bounces",
              "share of all orbits",
              {{"left", {}, true}, {"left, without an interval", {}, true}}};
    plot.log_y = true;
    for (std::size_t level = 0; level < plan_.levels; ++level) {
      const Measure left = share(level);
      const double n = static_cast<double>((level + 1) * plan_.bounces);
      table.add({n, left.value, left.standard_error});
      const auto half = half_interval(left);
      plot.series[half ? 0 : 1].points.push_back({n, left.value, half.value_or(0)});
    }
    ExperimentResult all = measured(context_, "splitting", headline(), measures());
    all.files.push_back(csv_file("splitting_levels", table));
    add_plot(all, "splitting", plot, context_.threads);
    return all;
  }

 private:
  Measure share(std::size_t level) const {
    const auto of = [&](const std::vector<SplitGroup>& groups) {
      RatioSums sums;
      for (const SplitGroup& one : groups) sums.add(one.share[level], 1);
      return sums.measure("left");
    };
    Measure near = of(near_);
    const Measure far = of(far_);
    if (near.value > 0 && far.value > 0 &&
        near.standard_error.value_or(kInfinity) * std::sqrt(near.freedom + 1) <=
            kWidest * near.value)
      return not_turned(near, far);
    near.standard_error.reset();
    return near;
  }

  // Between two levels, by what the groups differ by.
  Measure rate(std::size_t first, std::size_t last) const {
    const auto of = [&](const std::vector<SplitGroup>& groups) {
      RatioSums sums;
      for (const SplitGroup& one : groups) sums.add(one.share[last], one.share[first]);
      const double bounces = static_cast<double>((last - first) * plan_.bounces);
      Measure found = sums.measure("escape_rate_per_bounce");
      if (found.standard_error) *found.standard_error /= found.value * bounces;
      found.value = -portable::log(found.value) / bounces;
      return found;
    };
    return not_turned(of(near_), of(far_));
  }

  // The two halves of the levels agree, and not as well with a power of the bounces.
  bool is_exponential() const {
    const std::size_t last = plan_.levels - 1, middle = (plan_.first + last) / 2;
    const Measure a = rate(plan_.first, middle), b = rate(middle, last);
    if (!a.standard_error || !b.standard_error) return false;
    const auto differ = [&](double share) {  // a from share times b, in errors
      return std::fabs(a.value - share * b.value) /
             std::sqrt(*a.standard_error * *a.standard_error +
                       share * share * *b.standard_error * *b.standard_error);
    };
    const auto slope = [](std::size_t from, std::size_t to) {
      return portable::log(static_cast<double>(to + 1) / static_cast<double>(from + 1)) /
             static_cast<double>(to - from);
    };
    const double power = differ(slope(plan_.first, middle) / slope(middle, last));
    return differ(1) <= kAllowedErrors && power > kAllowedErrors;
  }

  std::vector<Measure> measures() const {
    Measure left = share(plan_.levels - 1);
    left.name = fmt::format("left_after_{}_bounces", plan_.levels * plan_.bounces);
    left.remark = left.standard_error
                      ? fmt::format("relative error {:.2g}", *left.standard_error / left.value)
                      : fmt::format(
                            "no error: {}; clones part too late (a larger --apart helps), or "
                            "--count is too small",
                            left.value > 0 ? "the groups differ too much, or turn too far"
                                           : "no orbit is left");
    double ancestors = 0;
    for (const SplitGroup& one : near_) ancestors += one.ancestors;
    ancestors /= static_cast<double>(near_.size());
    std::vector<Measure> all{left};
    if (left.value > 0) {
      const std::size_t last = plan_.levels - 1;
      Measure by_bounce = rate(plan_.first, last);
      Measure by_length =
          not_turned(rate_by_length(near_, plan_.first), rate_by_length(far_, plan_.first));
      const bool exponential = is_exponential();
      for (Measure* one : {&by_bounce, &by_length}) {
        one->remark = fmt::format("from bounce {} to {}", (plan_.first + 1) * plan_.bounces,
                                  plan_.levels * plan_.bounces);
        const bool forgotten = plan_.first >= kForgotten;
        if (!one->standard_error)
          one->remark += "; no error: clones are turned too far, say a smaller --apart";
        if (!left.standard_error || !exponential || !forgotten) one->standard_error.reset();
        if (!exponential) {
          one->name = "fit_of_a_" + one->name.substr(std::string_view("escape_").size());
          one->remark = "no rate: earlier and later levels differ, or agree as well with a power";
        }
        if (exponential && !forgotten)
          one->remark += fmt::format("; no error: fewer than {} levels, the beginning may be felt",
                                     3 * kForgotten);
        all.push_back(std::move(*one));
      }
    }
    const auto orbits = static_cast<double>(kGroups * plan_.orbits * plan_.levels);
    all.push_back(
        remarked("orbits_followed", orbits,
                 fmt::format("as many without splitting would leave {:.2g}", orbits * left.value)));
    all.push_back(
        remarked("ancestors_of_a_group", ancestors,
                 fmt::format("of {} starts, those from which its last orbits come", plan_.orbits)));
    return all;
  }

  std::string headline() const {
    return fmt::format(
        "{} groups of {} orbits, split at {} levels of {} bounces; clones are turned by up to "
        "{:.3g} at their wall (--apart), {} times as far in {} groups: numbers are told as if none "
        "were",
        kGroups, plan_.orbits, plan_.levels, plan_.bounces, plan_.apart, kFarther,
        kGroups / kOneIn);
  }

  const ExperimentContext& context_;
  const SplittingPlan& plan_;
  std::vector<SplitGroup> near_, far_;
};

Result<ExperimentResult> run(const ExperimentContext& context) {
  const Room room(context.scene);
  if (auto walls = expect_walls(context, room); !walls) return fail(std::move(walls));
  if (auto plane = expect_not_periodic(context); !plane) return fail(std::move(plane));
  FLATRAY_TRY(plan, plan_of(context, room));
  SplittingPlan far = *plan;
  far.apart *= kFarther;
  FLATRAY_TRY(
      found, run_blocks(context, kGroups, [&](std::size_t group) {
        return split_group(context, room, Report::is_far(group) ? far : *plan, group).numbers();
      }));
  return Report(context, *plan, *found).result();
}

}  // namespace

extern const Experiment entry = {
    "splitting",
    "How many orbits are left in an open room when a plain ensemble sees none?",
    &run,
    {.count = true,
     .bounces = true,
     .apart = true,
     .seed = true,
     .resume = true,
     .precision = true}};

}  // namespace flatray::splitting_experiment
