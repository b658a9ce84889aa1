#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "base/counted.h"
#include "base/portable_math.h"
#include "collide/pillars.h"
#include "study/periodic/cycle_expansion.h"
#include "study/periodic/escape_bounds.h"
#include "study/periodic/periodic_plots.h"
#include "study/periodic/symmetry.h"
#include "study/periodic/words.h"
#include "study/statistics/estimate.h"

namespace flatray::periodic_experiment {
namespace {

constexpr std::uint64_t kUsualSymbols = 6;
constexpr double kMostReduced = 1 << 18;  // words looked through for reduced ones
constexpr Verdict kVerdicts[] = {Verdict::proven, Verdict::family, Verdict::pruned,
                                 Verdict::undecided, Verdict::not_found};

// Its middle, or an end of it; null of nothing.
template <class Part>
JsonValue cell(const std::optional<Near>& number, Part part) {
  return number ? JsonValue(std::invoke(part, *number)) : JsonValue();
}

// As many as three discs have of two bounces more than twice those of the longest orbit; some 160
// MB.
std::size_t words_for_bounds(std::size_t symbols) {
  constexpr std::size_t kMostSymbols = 10;
  return std::size_t{6} << 2 * std::min(symbols, kMostSymbols);
}

// How neighbours go, where that is proven.
const char* stability_of(const ClosedOrbit& orbit) {
  if (orbit.verdict == Verdict::family) return "parabolic";
  if (orbit.verdict != Verdict::proven) return "";
  if (orbit.eigenvalue()) return "hyperbolic";
  const auto inside = (Near(4) - orbit.trace * orbit.trace).sign();
  return inside == Sign::positive ? "elliptic" : "parabolic or nearly";
}

class PeriodicOrbits {
 public:
  PeriodicOrbits(const ExperimentContext& context, const MirrorRoom& room, std::size_t symbols,
                 std::vector<ClosedOrbit> orbits)
      : context_(context), room_(room), symbols_(symbols), orbits_(std::move(orbits)) {
    for (const ClosedOrbit& orbit : orbits_) {
      const auto verdict = static_cast<std::size_t>(orbit.verdict);
      ++counts_[orbit.word.size()][verdict];
      ++totals_[verdict];
    }
    expand();
  }

  ExperimentResult result() const {
    ExperimentResult all = measured(context_, "periodic", headline(), measures());
    const Table counts = table_of_counts();
    all.summary += "\n" + aligned_text(counts, kBrief);
    all.files.push_back(csv_file("periodic_orbits", table_of_orbits()));
    all.files.push_back(csv_file("periodic_counts", counts));
    if (!means_.empty()) {
      const Table means = table_of_means();
      all.summary += "\n" + aligned_text(means);
      all.files.push_back(csv_file("periodic_expansion", means));
    }
    const std::vector<const ClosedOrbit*> shown = one_of_those_alike();
    if (!shown.empty()) {
      add_plot(all, "periodic", plot_of_orbits(room_, shown), context_.threads);
      if (const Plot plot = plot_of_stability(shown); !plot.series.empty())
        add_plot(all, "periodic_stability", plot, context_.threads);
    }
    return all;
  }

 private:
  std::string headline() const {
    std::string walls;
    for (std::size_t i = 0; i < room_.mirrors.size(); ++i)
      walls +=
          fmt::format("{}{} {}", i > 0 ? ", " : "", i + 1, wall_name(room_.mirrors[i].surface));
    return fmt::format(
        "Closed orbits of up to {} by the walls they bounce off: {}\n"
        "{} of the room, but for rounding; {}",
        counted(symbols_, "bounce"), walls, counted(symmetries_.size(), "symmetry", "symmetries"),
        expansion_words_);
  }

  std::string wall_name(std::uint32_t surface) const {
    const SurfaceOwner& owner = room_.room.owner(surface);
    const std::string name = owner_name(context_.scene, owner);
    return owner.edge >= 0 ? fmt::format("{} {}", name, owner.edge + 1) : name;
  }

  std::uint64_t total(Verdict verdict) const { return totals_[static_cast<std::size_t>(verdict)]; }

  // A mean over all orbits needs all of them, and that each wall may follow every other.
  void expand() {
    const bool discs =
        std::ranges::all_of(room_.mirrors, [](const Mirror& one) { return one.is_disc(); });
    const bool unstable = std::ranges::all_of(orbits_, [](const ClosedOrbit& one) {
      return one.verdict == Verdict::proven && one.eigenvalue();
    });
    if (!discs || !unstable || orbits_.empty()) {
      expansion_words_ =
          "no cycle expansion: that is for rooms of discs alone, all of whose words have a proven "
          "orbit";
      return;
    }
    std::vector<Cycle> cycles = reduced_cycles();
    expansion_words_ =
        fmt::format("cycle expansion by {} that symmetry leaves", counted(cycles.size(), "orbit"));
    if (cycles.empty()) {
      expansion_words_ = "cycle expansion by all orbits, not reduced by symmetry";
      for (const ClosedOrbit& orbit : orbits_)
        cycles.push_back({orbit.word.size(), orbit.length.value(), orbit.eigenvalue()->value()});
    }
    means_ = cycle_means(cycles, symbols_);
    if (means_.empty()) {
      expansion_words_ += ", which has no zero: say more --symbols";
      return;
    }
    const auto bounds =
        escape_bounds(context_, room_, words_for_bounds(symbols_), means_.back().escape_rate);
    if (bounds) bounds_ = *bounds;
    expansion_words_ +=
        bounds
            ? fmt::format("; escape rates are bounded by all words of {} bounces", bounds->bounces)
            : fmt::format("; no bounds of escape rates: {}", bounds.error());
  }

  // None where there is no symmetry, or one that cannot be made use of.
  std::vector<Cycle> reduced_cycles() {
    std::vector<Cycle> cycles;
    const auto mirrors = static_cast<double>(room_.mirrors.size());
    double tried = static_cast<double>(symmetries_.size());
    for (std::size_t n = 0; n < symbols_; ++n) tried *= mirrors - 1;
    if (symmetries_.size() < 2 || !are_told_apart(symmetries_) || tried > kMostReduced) return {};
    for (std::size_t n = 1; n <= symbols_; ++n) {
      const auto words = reduced_words(symmetries_, room_.mirrors.size(), n);
      if (!words) return {};
      for (const ReducedWord& reduced : *words) {
        const ClosedOrbit whole = disc_orbit(room_, reduced.word);
        if (whole.verdict != Verdict::proven || !whole.eigenvalue()) return {};
        const auto parts = static_cast<double>(reduced.parts);
        const double size =
            portable::exp(portable::log(std::fabs(whole.eigenvalue()->value())) / parts);
        const bool negative = (n % 2 == 1) != reduced.turned;
        cycles.push_back({n, whole.length.value() / parts, negative ? -size : size});
        ++reduced_[n];
      }
    }
    return cycles;
  }

  std::vector<Measure> measures() const {
    std::vector<Measure> all;
    for (const Verdict verdict : kVerdicts) {
      const bool orbits = verdict == Verdict::proven || verdict == Verdict::family;
      if (total(verdict) > 0)
        all.push_back(remarked(fmt::format("{}{}", orbits ? "orbits " : "words ", name_of(verdict)),
                               static_cast<double>(total(verdict)), "counted"));
    }
    if (means_.empty()) return all;
    const std::size_t from = means_.size() - std::min<std::size_t>(3, means_.size());
    const auto add = [&](const char* name, double CycleMeans::*of,
                         const std::optional<Range>& proven = std::nullopt) {
      Measure one{name, means_.back().*of};
      one.proven = proven;
      // Of orbits that are too few, or as rounding lets them, the last row may lie beyond.
      const bool beyond = proven && !(proven->low <= one.value && one.value <= proven->high);
      if (beyond) one.value = proven->low + (proven->high - proven->low) / 2;
      one.remark = proven ? fmt::format("proven: from {} to {}; ", proven->low, proven->high)
                          : "not proven: ";
      one.remark += "orbits";
      for (std::size_t i = from; i < means_.size(); ++i)
        one.remark += fmt::format("{} up to {} give {:.12g}", i > from ? "," : "",
                                  means_[i].bounces, means_[i].*of);
      if (beyond) one.remark += ", beyond the bounds: their middle is told";
      all.push_back(one);
    };
    const auto proven = [&](Range EscapeBounds::*of) {
      return bounds_ ? std::optional((*bounds_).*of) : std::nullopt;
    };
    add("escape_rate", &CycleMeans::escape_rate, proven(&EscapeBounds::per_length));
    add("escape_rate_per_bounce", &CycleMeans::escape_rate_bounce,
        proven(&EscapeBounds::per_bounce));
    add("mean_flight", &CycleMeans::flight);
    add("lyapunov", &CycleMeans::lyapunov);
    return all;
  }

  Table table_of_counts() const {
    std::vector<std::string> columns{"bounces"};
    std::vector<Verdict> seen;
    for (const Verdict verdict : kVerdicts)
      if (total(verdict) > 0) {
        seen.push_back(verdict);
        columns.emplace_back(name_of(verdict));
      }
    const bool by_symmetry = std::ranges::max(reduced_) > 0;
    if (by_symmetry) columns.emplace_back("by symmetry, proven");
    Table table(columns);
    for (std::size_t n = 1; n <= symbols_; ++n) {
      Values row{std::uint64_t{n}};
      for (const Verdict verdict : seen)
        row.emplace_back(counts_[n][static_cast<std::size_t>(verdict)]);
      if (by_symmetry) row.emplace_back(reduced_[n]);
      table.add(std::move(row));
    }
    return table;
  }

  Table table_of_means() const {
    Table table(
        {"cut off after", "escape_rate", "escape_rate_per_bounce", "mean_flight", "lyapunov"});
    for (const CycleMeans& one : means_)
      table.add({std::uint64_t{one.bounces}, one.escape_rate, one.escape_rate_bounce, one.flight,
                 one.lyapunov});
    return table;
  }

  Table table_of_orbits() const {
    Table table({"word", "number", "bounces", "verdict", "words_alike", "length", "length_low",
                 "length_high", "stability", "eigenvalue", "eigenvalue_low", "eigenvalue_high",
                 "why"});
    for (const ClosedOrbit& orbit : orbits_) {
      const auto length = orbit.is_there() ? std::optional(orbit.length) : std::nullopt;
      const auto value = orbit.is_there() ? orbit.eigenvalue() : std::nullopt;
      table.add({room_.text(orbit.word), std::uint64_t{orbit.number},
                 std::uint64_t{orbit.word.size()}, std::string(name_of(orbit.verdict)),
                 std::uint64_t{words_alike(orbit.word, symmetries_)}, cell(length, &Near::value),
                 cell(length, &Near::low), cell(length, &Near::high), stability_of(orbit),
                 cell(value, &Near::value), cell(value, &Near::low), cell(value, &Near::high),
                 orbit.why});
    }
    return table;
  }

  // Of words alike the least; of several orbits of one word all.
  std::vector<const ClosedOrbit*> one_of_those_alike() const {
    std::vector<const ClosedOrbit*> all;
    for (const ClosedOrbit& orbit : orbits_) {
      if (!orbit.is_there()) continue;
      const bool least = std::ranges::all_of(symmetries_, [&](const Symmetry& by) {
        return least_turn(orbit.word) <= least_turn(taken(orbit.word, by));
      });
      if (least) all.push_back(&orbit);
    }
    return all;
  }

  const ExperimentContext& context_;
  const MirrorRoom& room_;
  std::size_t symbols_;
  std::vector<ClosedOrbit> orbits_;
  std::vector<Symmetry> symmetries_ = symmetries(room_);
  using Counts = std::array<std::uint64_t, std::size(kVerdicts)>;   // by verdict
  std::vector<Counts> counts_ = std::vector<Counts>(symbols_ + 1);  // by bounces
  Counts totals_{};
  std::vector<std::uint64_t> reduced_ = std::vector<std::uint64_t>(symbols_ + 1);  // by bounces
  std::vector<CycleMeans> means_;
  std::optional<EscapeBounds> bounds_;
  std::string expansion_words_;
};

Result<ExperimentResult> run(const ExperimentContext& context) {
  if (auto plain = expect_not_periodic(context); !plain) return fail(std::move(plain));
  if (auto inside = expect_pillars_inside(context.scene); !inside) return fail(std::move(inside));
  if (auto apart = expect_pillars_apart(context.scene); !apart) return fail(std::move(apart));
  const Room room(context.scene);
  if (auto walls = expect_walls(context, room); !walls) return fail(std::move(walls));
  FLATRAY_TRY(mirrors, MirrorRoom::of(room));
  const auto symbols = static_cast<std::size_t>(context.symbols.value_or(kUsualSymbols));
  FLATRAY_TRY(orbits, orbits_by_word(context, *mirrors, symbols));
  const PeriodicOrbits found(context, *mirrors, symbols, std::move(*orbits));
  return found.result();
}

}  // namespace

extern const Experiment entry = {
    "periodic",
    "Which orbits close, by the walls in order, and what do they say of the room?",
    &run,
    {.symbols = true}};

}  // namespace flatray::periodic_experiment
