#include "study/rooms/conditional_starts.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/counted.h"
#include "base/parallel.h"

namespace flatray {
namespace {

constexpr std::uint64_t kPilot = std::uint64_t{1} << 18;  // orbits, at most
constexpr std::uint64_t kLeastOrbits = 100;               // of a group
constexpr double kForgotten = 3;  // memories: what is left of the beginning is its third power
constexpr double kSmallTurn = 0x1p-7;
constexpr double kLogOfFour = 1.3862943611198906;  // a quarter is left at a level

// How starts by the measure that reflection keeps leave.
Result<Survival> natural_survival(const ExperimentContext& context, const Room& room,
                                  std::uint64_t bounces) {
  const std::uint64_t count = std::min(context.count, kPilot);
  FLATRAY_TRY(outcomes, trace_pilot(context, room, bounces, count));
  const Survival found = survival(departures_of(*outcomes));
  const Place where = context.scene.where;
  if (found.law == Survival::Law::power)
    return fail(where,
                fmt::format("orbits leave like (n + 1)^-{:.3g}, not exponentially: what is left "
                            "comes to no conditionally invariant measure",
                            found.power),
                "leave --starts conditional out", Trouble::usage);
  if (found.law == Survival::Law::undecided)
    return fail(where,
                fmt::format("of {} it cannot be told whether they leave exponentially",
                            counted(count, "orbit")),
                "say a larger --count, or leave --starts conditional out", Trouble::usage);
  return found;
}

// Points that fast orbits bounce at may lie behind their wall, by rounding: exact ones would meet
// it at once.
std::vector<OrbitStart> in_front_of_walls(const Room& room, const std::vector<Walker>& walkers) {
  std::vector<OrbitStart> starts;
  for (const Walker& one : walkers) {
    starts.push_back(one.at);
    const auto origin = in_front_of(room.walls(), one.at.departed.surface,
                                    side_of_start(room, one.at), one.at.ray.origin);
    if (origin) starts.back().ray.origin = *origin;
  }
  return starts;
}

}  // namespace

std::vector<LeavingOrbit> departures_of(std::span<const PixelOutcome> orbits) {
  using Kind = PixelOutcome::Kind;
  std::vector<LeavingOrbit> all;
  for (const PixelOutcome& one : orbits)
    if (one.kind != Kind::solid)
      all.push_back({static_cast<double>(one.bounces), one.length, one.kind != Kind::limit});
  return all;
}

Result<ConditionalStarts> ConditionalStarts::draw(const ExperimentContext& context,
                                                  const Room& room, std::uint64_t bounces) {
  const std::uint64_t orbits = (context.count + kShifts - 1) / kShifts;
  if (orbits < kLeastOrbits)
    return refused_option(
        "--count",
        fmt::format("conditional starts in {} groups of {}", kShifts, counted(orbits, "orbit")),
        fmt::format("say --count {} or more", kShifts * kLeastOrbits));
  FLATRAY_TRY(natural, natural_survival(context, room, bounces));
  ConditionalStarts found;
  found.memory_ = *late_start(*natural);
  const double step = std::max(1.0, std::floor(kLogOfFour / natural->rate));
  const SplittingPlan plan{orbits,
                           static_cast<std::uint64_t>(std::ceil(kForgotten * found.memory_ / step)),
                           static_cast<std::uint64_t>(step), 0, kSmallTurn};
  found.groups_.resize(kShifts);
  parallel_for(kShifts, context.threads, [&](std::size_t group) {
    Population population(context, room, plan, group);
    for (std::uint64_t level = 0; level < plan.levels && !context.stopped(); ++level) {
      population.advance();
      if (population.walkers().empty()) return;
      population.clone();
    }
    found.groups_[group] = in_front_of_walls(room, population.walkers());
  });
  for (const auto& group : found.groups_)
    if (group.empty())
      return refused_option("--count", "a group of conditional starts died out",
                            "say a larger --count");
  return found;
}

}  // namespace flatray
