#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "base/table.h"
#include "study/rooms/exits.h"
#include "study/rooms/flight_tail.h"
#include "study/rooms/followed.h"
#include "study/rooms/survival.h"

namespace flatray::recurrence_experiment {
namespace {

using Kind = PixelOutcome::Kind;

constexpr std::uint64_t kBounces = 1'000'000;
constexpr double kPi = 0x1.921fb54442d18p+1;
constexpr std::uint64_t kPilot = 2000;  // orbits: what none of them is of moves no mean by an error
// Mean returns: what comes at random comes within the first, and few others come within the second.
constexpr double kTimes[] = {50, 5000};
constexpr std::uint64_t kFew = 20;  // of a pilot one in so many
constexpr double kLeastIndex = 4;   // as of FlightTail: from 2 on there is a variance

// Of the walls.
double part_of_holes(const Room& room) {
  return length_of(room, holes_of(room)) / room.perimeter();
}

// Kac's lemma counts what never comes to a hole among the walls, though no orbit of the run is
// there: a part that is closed off, or that orbits keep to. What of a pilot it is; "": nothing.
Result<std::string> what_never_comes(const ExperimentContext& context, const Room& room,
                                     std::uint64_t bounces) {
  const std::uint64_t count = std::min(context.count, kPilot);
  std::string stayed;
  for (const double times : kTimes) {
    const double most = std::ceil(times / part_of_holes(room));
    const auto looked = static_cast<std::uint64_t>(std::min(static_cast<double>(bounces), most));
    FLATRAY_TRY(orbits, trace_pilot(context, room, looked, count));
    const auto stay = static_cast<std::uint64_t>(std::ranges::count_if(
        *orbits, [](const PixelOutcome& one) { return one.kind != Kind::absorbed; }));
    if (stay == 0) return std::string();
    stayed = fmt::format(
        "no closed form: {} of {} orbits from all walls did not come to a hole in {} bounces", stay,
        count, looked);
    if (stay > count / kFew) break;
  }
  return stayed;
}

class Returns {
 public:
  /// `unswept`: why Kac's lemma tells nothing; "": all of the room comes to the holes.
  Returns(const ExperimentContext& context, const Room& room, std::span<const PixelOutcome> orbits,
          std::string unswept)
      : context_(context), room_(room), unswept_(std::move(unswept)), part_(part_of_holes(room)) {
    std::vector<LeavingOrbit> departures;
    std::vector<double> times;
    for (const PixelOutcome& one : orbits) {
      const bool back = one.kind == Kind::absorbed;
      departures.push_back({static_cast<double>(one.bounces), one.length, back});
      if (!back) {
        ++away_;
        continue;
      }
      times.push_back(one.bounces + 1.0);
      arrivals_.add(times.back(), 1);
      ways_.add(one.way, 1);
      if (one.bounces >= back_at_.size()) back_at_.resize(std::size_t{one.bounces} + 1);
      ++back_at_[one.bounces];
    }
    law_ = survival(departures);
    tail_.add(times, 1);
  }

  ExperimentResult result(const std::vector<Measure>& audit) const {
    ExperimentResult found = measured(context_, "recurrence", headline(), measures(), audit);
    Table table({"arrivals", "returned", "still_away", "exponential_law"});
    Plot plot{"Orbits still away from where they set off",
              "arrivals at walls, by their mean until the return",
              "share of the orbits",
              {{"orbits", {}, false}, {"e^-t", {}, false}}};
    plot.log_y = true;
    double away = arrivals_.samples + away_;
    const double all_orbits = away;
    for (std::size_t n = 0; n < back_at_.size(); ++n) {
      if (back_at_[n] == 0) continue;
      away -= back_at_[n];
      const double arrivals = static_cast<double>(n) + 1, t = arrivals * part_;
      const double law = portable::exp(-t);
      table.add({arrivals, back_at_[n], away, law});
      plot.series[0].points.push_back({t, away / all_orbits});
      if (law * all_orbits >= 1) plot.series[1].points.push_back({t, law});
    }
    found.files.push_back(csv_file("recurrence_times", table));
    add_plot(found, "recurrence", plot, context_.threads);
    return found;
  }

 private:
  std::vector<Measure> measures() const {
    Measure arrivals = arrivals_.measure("mean_arrivals", 1 / part_);
    const double holes = part_ * room_.perimeter();
    Measure way = ways_.measure("mean_way", kPi * room_.solids().free_area() / holes);
    const std::string why = no_error();
    for (Measure* one : {&arrivals, &way}) {
      if (unswept_.empty()) one->remark = "until the return; expected by Kac's lemma";
      if (!why.empty()) withhold_error(*one, why);
      if (unswept_.empty()) continue;
      one->expected.reset();
      one->remark += (why.empty() ? "" : "; ") + unswept_;
    }
    return {arrivals, way, {"orbits_still_away", away_}, {"index_of_long_times", tail_.index()}};
  }

  std::string no_error() const {
    if (away_ > 0)
      return fmt::format("too small: {:.0f} orbits are still away after all bounces", away_);
    const double index = tail_.index();
    if (index == 0) return "no error: too few orbits to tell whether times have a variance";
    if (index >= kLeastIndex || law_.law == Survival::Law::exponential) return "";
    return fmt::format(
        "no error: times longer than t fall about like t^-{:.1f}, and have no variance that could "
        "be relied on",
        index);
  }

  std::string headline() const {
    using Law = Survival::Law;
    const std::string fits =
        law_.freedom == 0              ? "too few to tell how they fall"
        : law_.law == Law::exponential ? fmt::format("fall like e^(-{:.4g} n)", law_.rate)
        : law_.law == Law::power       ? fmt::format("fall like (n + 1)^-{:.3g}", law_.power)
                                 : "fall like neither an exponential nor a power, or like both";
    return fmt::format(
        "{:.0f} orbits set off from the holes, which are {:.6g} of the walls, and come back to "
        "them; those still away after n bounces {}",
        arrivals_.samples + away_, part_, fits);
  }

  const ExperimentContext& context_;
  const Room& room_;
  std::string unswept_;
  double part_, away_ = 0;
  RatioSums arrivals_, ways_;
  FlightTail tail_;
  Survival law_;
  std::vector<double> back_at_;  // by number of bounces
};

// On the holes, uniform in their length.
OrbitStart draw_on(const Room& room, std::span<const std::uint32_t> holes, std::uint64_t seed,
                   std::uint64_t number) {
  const double along = length_of(room, holes) * drawn_unit(seed, number, 0);
  std::size_t hole = 0;
  double end = room.places().length(holes[hole]);
  while (hole + 1 < holes.size() && end <= along) end += room.places().length(holes[++hole]);
  // Another number, so that the place on the hole is another draw.
  return room.draw_entry(holes[hole], seed, number + (std::uint64_t{1} << 48));
}

Result<ExperimentResult> run(const ExperimentContext& context) {
  if (auto holes = expect_holes(context); !holes) return fail(std::move(holes));
  const Room room(context.scene);
  const std::vector<std::uint32_t> holes = holes_of(room);
  const std::uint64_t bounces = context.bounces.value_or(kBounces);
  const auto start = [&](std::uint64_t i) { return draw_on(room, holes, context.seed, i); };
  FLATRAY_TRY(unswept, what_never_comes(context, room, bounces));
  FLATRAY_TRY(orbits, trace_outcomes(context, room, bounces, context.count, 0, start));
  return Returns(context, room, *orbits, *unswept)
      .result(audit(context, room, audited_starts(context, context.count, start), bounces));
}

}  // namespace

extern const Experiment entry = {
    "recurrence",
    "After how long does what sets off from the holes of a room come back to them?",
    &run,
    {.count = true, .bounces = true, .seed = true, .resume = true, .precision = true}};

}  // namespace flatray::recurrence_experiment
