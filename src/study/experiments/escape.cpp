#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "base/table.h"
#include "study/plots/plot.h"
#include "study/rooms/conditional_starts.h"
#include "study/rooms/exits.h"
#include "study/rooms/followed.h"

namespace flatray::escape_experiment {
namespace {

using Kind = PixelOutcome::Kind;

constexpr std::uint64_t kBounces = 1000;
constexpr LinearRgb kSolid{0.02, 0.02, 0.025}, kTrapped{1, 1, 1}, kCorner{0.35, 0.35, 0.35};

// Who absorbed a ray: an entity, pillar or chamber, or a hole of it.
using Exit = std::tuple<SurfaceOwner::Kind, std::uint32_t, std::uint32_t, std::uint32_t>;

class Basins {
 public:
  /// `pixels`, and what starts are drawn; `memory` of conditional ones.
  Basins(const ExperimentContext& context, const Room& room, std::uint64_t bounces,
         std::span<const PixelOutcome> pixels, std::span<const PixelOutcome> drawn, double memory)
      : context_(context),
        room_(room),
        bounces_(bounces),
        memory_(memory),
        pixels_(pixels),
        drawn_(departures_of(drawn)),
        survival_(survival(drawn_, context.starts)) {
    if (!holes_of(room).empty())
      exits_by_hole_.emplace(context, room, drawn, late_start(survival_));
    for (const PixelOutcome& pixel : pixels_) {
      if (pixel.kind == Kind::solid) continue;
      ++free_;
      if (pixel.kind == Kind::limit) ++trapped_;
      if (pixel.kind == Kind::escape) ++escaped_;
      if (pixel.kind == Kind::corner) ++cornered_;
      if (pixel.kind == Kind::absorbed) ++exits_[exit_of(pixel)];
      if (pixel.kind == Kind::limit) continue;
      if (pixel.bounces >= gone_after_.size()) gone_after_.resize(std::size_t{pixel.bounces} + 1);
      ++gone_after_[pixel.bounces];
    }
  }

  ExperimentResult result(const std::vector<Measure>& audit) const {
    ExperimentResult all = measured(context_, "escape", headline(), measures(), audit);
    Table table({"bounces", "pixels_gone", "pixels_remaining"});
    Plot plot{"Pixels whose orbits remain", "bounces", "pixels", {{"remaining", {}, true}}, true};
    std::uint64_t remaining = free_;
    for (std::size_t n = 0; n < gone_after_.size(); ++n) {
      remaining -= gone_after_[n];
      table.add({std::uint64_t{n}, gone_after_[n], remaining});
      plot.series[0].points.push_back({static_cast<double>(n), static_cast<double>(remaining)});
    }
    all.files.push_back(csv_file("escape_times", table));
    all.files.push_back({"escape_times.svg", svg(plot)});
    add_map(all, "escape", map_of_basins(), context_.threads,
            [&](std::size_t i) { return bounces_text(pixels_[i]); });
    if (!exits_by_hole_) return all;
    all.files.push_back(csv_file("escape_exits", exits_by_hole_->table()));
    add_plot(all, "escape_exit_places", exits_by_hole_->plot_of_places(), context_.threads);
    add_plot(all, "escape_exit_sines", exits_by_hole_->plot_of_sines(), context_.threads);
    return all;
  }

 private:
  Exit exit_of(const PixelOutcome& pixel) const {
    const SurfaceOwner& owner = room_.owner(pixel.surface);
    return {owner.kind, owner.index, owner.pillar, owner.hole};
  }

  std::string exit_name(const Exit& exit) const {
    const auto& [kind, index, pillar, hole] = exit;
    const Scene& scene = context_.scene;
    if (hole != kNoEntry) return scene.chambers[index].holes[hole].name;
    return owner_name(scene, {kind, index, pillar, kNoEdge, {}});
  }

  std::vector<Measure> measures() const {
    const auto free = static_cast<double>(free_);
    const auto share = [&](std::string name, std::uint64_t count) {
      return remarked(std::move(name), static_cast<double>(count) / free, "of the pixels, counted");
    };
    std::vector<Measure> all;
    for (const auto& [exit, count] : exits_) all.push_back(share("into " + exit_name(exit), count));
    all.push_back(share("into the open", escaped_));
    if (cornered_ > 0) all.push_back(share("into a corner", cornered_));
    all.push_back(share("trapped", trapped_));
    add_decay(all);
    if (exits_by_hole_)
      for (Measure& one : exits_by_hole_->measures()) all.push_back(std::move(one));
    return all;
  }

  // A rate where there is one; else both fits, which are no more than that.
  void add_decay(std::vector<Measure>& all) const {
    using Law = Survival::Law;
    if (survival_.freedom == 0) return;
    if (survival_.law == Law::exponential) {
      for (Measure& rate : escape_rates(drawn_, survival_, bounces_, context_.starts, memory_))
        all.push_back(std::move(rate));
      return;
    }
    const auto add = [&](const char* name, double value, double rest) {
      all.push_back(remarked(name, value,
                             fmt::format("no error: leaves {:.3g} for {:.0f} degrees of freedom",
                                         rest, survival_.freedom)));
    };
    add("fit_of_a_rate_per_bounce", survival_.rate, survival_.rate_rest);
    add("fit_of_a_power_of_flights", survival_.power, survival_.power_rest);
  }

  std::string decay_words() const {
    using Law = Survival::Law;
    if (survival_.freedom == 0 && std::ranges::none_of(drawn_, &LeavingOrbit::gone))
      return fmt::format("none of {} drawn orbits leaves within the bounces looked at",
                         drawn_.size());
    if (survival_.freedom == 0)
      return fmt::format("of {} drawn orbits too few stay to tell how their number falls",
                         drawn_.size());
    const std::string of =
        fmt::format("of {} drawn orbits, those left after n bounces fall ", drawn_.size());
    if (survival_.law == Law::exponential) return of + "exponentially";
    if (survival_.law == Law::power)
      return of + fmt::format("like (n + 1)^-{:.3g}: there is no rate", survival_.power);
    const double most = chi_squared_95(survival_.freedom);
    const bool neither =
        (survival_.rate_rest > most || survival_.outlasted()) && survival_.power_rest > most;
    return of + fmt::format("like {}e^(-{:.4g} n) {} (n + 1)^-{:.4g}{}{}",
                            neither ? "neither " : "", survival_.rate, neither ? "nor" : "or",
                            survival_.power, neither ? "" : ": undecided", outlasting_words());
  }

  std::string outlasting_words() const {
    if (!survival_.outlasted()) return "";
    return fmt::format("; one stays for {:.0f} bounces, after which the rate leaves {:.2g}",
                       survival_.last, survival_.left_then);
  }

  std::string headline() const {
    return fmt::format(
        "{} x {} pixels, an orbit each: {} start in the free, {} stay for all bounces; {}",
        context_.scene.film.width, context_.scene.film.height, free_, trapped_, decay_words());
  }

  // Of so many bounces on a scale of logarithms, from white to dark.
  static double brightness(double share) { return 0.06 + 0.94 * (1 - share) * (1 - share); }

  // Basins by colour: who absorbed the ray, or where it went; the darker the longer it stayed.
  Plot map_of_basins() const {
    const double most = gone_after_.empty() ? 0 : static_cast<double>(gone_after_.size() - 1);
    std::map<Exit, std::size_t> colours;
    for (const auto& [exit, count] : exits_) colours.emplace(exit, colours.size());
    Plot plot = pixel_plot(context_, room_, PixelMap::angle, [&](std::size_t i) {
      const PixelOutcome& pixel = pixels_[i];
      if (pixel.kind == Kind::limit) return kTrapped;
      if (pixel.kind == Kind::corner) return kCorner;
      if (pixel.kind == Kind::solid) return kSolid;
      const LinearRgb light =
          pixel.kind == Kind::escape ? hue_of(pixel.out) : nth_colour(colours.at(exit_of(pixel)));
      return light * brightness(most > 0 ? log_share(pixel.bounces, most) : 0);
    });
    plot.title = "Where a ray leaves, by its start";
    for (const auto& [exit, number] : colours)
      plot.kinds.emplace_back(hex(nth_colour(number)), exit_name(exit));
    if (escaped_ > 0)
      for (const auto& [words, out] : {std::pair("to the right", Vec2(1, 0)),
                                       {"up", Vec2(0, 1)},
                                       {"to the left", Vec2(-1, 0)},
                                       {"down", Vec2(0, -1)}})
        plot.kinds.emplace_back(hex(hue_of(out)), words);
    if (cornered_ > 0) plot.kinds.emplace_back(hex(kCorner), "into a corner");
    if (trapped_ > 0) plot.kinds.emplace_back(hex(kTrapped), "still there at the end");
    if (free_ < pixels_.size())
      plot.kinds.emplace_back(hex(kSolid), "starts in an obstacle, or outside");
    if (most > 0)
      plot.bar = bar_of(
          "brightness: bounces until it leaves", most,
          [](double part) { return grey(brightness(part)); },
          [&](double bounces) { return log_share(bounces, most); });
    return plot;
  }

  const ExperimentContext& context_;
  const Room& room_;
  std::uint64_t bounces_;
  double memory_;
  std::span<const PixelOutcome> pixels_;
  std::vector<LeavingOrbit> drawn_;
  Survival survival_;
  std::optional<Exits> exits_by_hole_;
  std::uint64_t free_ = 0, trapped_ = 0, escaped_ = 0, cornered_ = 0;
  std::map<Exit, std::uint64_t> exits_;
  std::vector<std::uint64_t> gone_after_;  // by number of bounces
};

Result<ExperimentResult> run(const ExperimentContext& context) {
  const Room room(context.scene);
  if (auto walls = expect_walls(context, room); !walls) return fail(std::move(walls));
  const bool holes = !holes_of(room).empty();
  if (!holes && context.starts == Starts::quasi)
    return refused_option("--starts", "without holes starts are drawn in the picture",
                          "say --starts conditional, or leave --starts out");
  const Film& film = context.scene.film;
  const std::uint64_t bounces = context.bounces.value_or(kBounces), count = pixel_count(film);
  const PlaceStarts places(context, room, PixelMap::angle);
  std::optional<ConditionalStarts> conditional;
  if (context.starts == Starts::conditional) {
    FLATRAY_TRY(found, ConditionalStarts::draw(context, room, bounces));
    conditional = std::move(*found);
  }
  const auto start = [&](std::uint64_t i) -> std::optional<OrbitStart> {
    if (i < count) return places[pixel_centre(film, i)];
    if (conditional) return (*conditional)[i - count];
    if (holes) return room.draw_start(context.seed, i - count, context.starts);
    return places[drawn_place(context.seed, i - count)];
  };
  FLATRAY_TRY(all, trace_outcomes(context, room, bounces, count + context.count, count, start));
  const std::span<const PixelOutcome> outcomes(*all);
  const std::vector<OrbitStart> audited =
      audited_starts(context, context.count, [&](std::uint64_t i) { return start(count + i); });
  return Basins(context, room, bounces, outcomes.first(count), outcomes.subspan(count),
                conditional ? conditional->memory() : 0)
      .result(audit(context, room, audited, bounces));
}

}  // namespace

extern const Experiment entry = {
    "escape",
    "Where does a ray from each pixel leave, and after how many bounces?",
    &run,
    {.count = true,
     .bounces = true,
     .map = true,
     .seed = true,
     .starts = true,
     .resume = true,
     .precision = true,
     .conditional = true,
     .glass = true}};

}  // namespace flatray::escape_experiment
