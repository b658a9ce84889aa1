#include "study/rooms/exits.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "study/rooms/starts.h"

namespace flatray {
namespace {

using Kind = PixelOutcome::Kind;

std::size_t cell_of(double share, std::size_t cells) {
  const auto count = static_cast<double>(cells);
  return static_cast<std::size_t>(std::clamp(share * count, 0.0, count - 1));
}

}  // namespace

std::vector<std::uint32_t> holes_of(const Room& room) {
  std::vector<std::uint32_t> holes;
  for (std::uint32_t i = 0; i < room.walls().size(); ++i)
    if (room.materials()[i] == Material::hole) holes.push_back(i);
  return holes;
}

double length_of(const Room& room, std::span<const std::uint32_t> surfaces) {
  double sum = 0;
  for (const std::uint32_t surface : surfaces) sum += room.places().length(surface);
  return sum;
}

Exits::Exits(const ExperimentContext& context, const Room& room,
             std::span<const PixelOutcome> drawn, std::optional<double> late)
    : context_(context), room_(room), drawn_(drawn), late_(late) {
  for (const std::uint32_t surface : holes_of(room)) {
    const SurfaceOwner& owner = room.owner(surface);
    holes_.push_back({surface, context.scene.chambers[owner.index].holes[owner.hole].name});
  }
  for (const PixelOutcome& one : drawn)
    if (one.kind == Kind::absorbed) add(one, late && one.bounces >= *late);
}

void Exits::add(const PixelOutcome& one, bool is_late) {
  const auto hole = std::ranges::find(holes_, one.surface, &Hole::surface);
  if (hole == holes_.end()) return;
  const WallPlaces& places = room_.places();
  const double along = places.position(one.surface, one.at) / places.length(one.surface);
  const double inward = static_cast<double>(room_.inner_side(one.surface).value_or(Sign::negative));
  const Vec2 normal = inward * wall_normal(room_.walls(), one.surface, one.at);
  const std::size_t place = cell_of(along, kCells),
                    angle = cell_of(0.5 * (sine_of(one.out, normal) + 1), kCells);
  ++hole->all[place][angle];
  ++left_;
  if (!is_late) return;
  ++hole->late[place][angle];
  ++left_late_;
}

Measure Exits::mean(std::string name, const std::function<double(const PixelOutcome&)>& of,
                    double from) const {
  StartSums sums(context_.starts);
  for (std::size_t i = 0; i < drawn_.size(); ++i)
    if (drawn_[i].kind == Kind::absorbed && drawn_[i].bounces >= from)
      sums.add(i, of(drawn_[i]), 1);
  Measure measure = sums.all().measure(std::move(name));
  const auto stay = std::ranges::count(drawn_, Kind::limit, &PixelOutcome::kind);
  if (late_ && stay == 0) return measure;
  withhold_error(measure,
                 stay > 0 ? fmt::format("no error: {} drawn orbits stay for all bounces", stay)
                          : "no error: orbits do not leave exponentially, so that the variance may "
                            "be infinite");
  return measure;
}

std::vector<Measure> Exits::measures() const {
  std::vector<Measure> all;
  const auto share = [&](std::string name, const std::function<bool(const PixelOutcome&)>& counts) {
    StartSums sums(context_.starts);
    for (std::size_t i = 0; i < drawn_.size(); ++i) sums.add(i, counts(drawn_[i]) ? 1 : 0, 1);
    all.push_back(sums.all().share(std::move(name)));
  };
  for (const Hole& hole : holes_)
    share("leaves_by " + hole.name, [&](const PixelOutcome& one) {
      return one.kind == Kind::absorbed && one.surface == hole.surface;
    });
  share("leaves_at_first_wall",
        [&](const PixelOutcome& one) { return one.kind == Kind::absorbed && one.bounces == 0; });
  if (context_.starts != Starts::conditional)
    all.back().expected = length_of(room_, holes_of(room_)) / room_.perimeter();
  const auto bounces = [](const PixelOutcome& one) { return static_cast<double>(one.bounces); };
  all.push_back(mean("mean_exit_bounces", bounces, 0));
  all.push_back(mean(
      "mean_exit_length", [](const PixelOutcome& one) { return one.way; }, 0));
  if (late_ && *late_ > 0) {
    all.push_back(mean(
        "mean_exit_bounces_late", [&](const PixelOutcome& one) { return one.bounces - *late_; },
        *late_));
    all.back().remark = fmt::format("further ones, of those left after {:.0f}", *late_);
  }
  return all;
}

Table Exits::table() const {
  Table table({"hole", "along_from", "along_to", "sine_from", "sine_to", "exits", "late_exits"});
  const auto edge = [](std::size_t i) { return static_cast<double>(i) / kCells; };
  for (const Hole& hole : holes_)
    for (std::size_t i = 0; i < kCells; ++i)
      for (std::size_t k = 0; k < kCells; ++k)
        table.add({hole.name, edge(i), edge(i + 1), 2 * edge(k) - 1, 2 * edge(k + 1) - 1,
                   hole.all[i][k], hole.late[i][k]});
  return table;
}

// Of all exits and of late ones, each at the x of its hole, place and sine; with what counts of
// independent orbits vary by, 95 % of them.
Plot Exits::plot_by(std::string title, std::string x_label,
                    double (*x_of)(std::size_t hole, std::size_t place, std::size_t sine)) const {
  constexpr double kMost = 1.959963984540054;
  std::map<double, std::array<double, 2>> counts;  // by x
  for (std::size_t h = 0; h < holes_.size(); ++h)
    for (std::size_t i = 0; i < kCells; ++i)
      for (std::size_t k = 0; k < kCells; ++k) {
        auto& [all, late] = counts[x_of(h, i, k)];
        all += holes_[h].all[i][k];
        late += holes_[h].late[i][k];
      }
  Plot plot{std::move(title),
            std::move(x_label),
            "exits, relative to an even spread",
            {{"all", {}, false}, {"late", {}, false}}};
  const double sums[] = {left_, left_late_};
  const bool conditional =
      context_.starts == Starts::conditional;  // whose orbits are not independent
  for (const auto& [x, both] : counts)
    for (std::size_t k = 0; k < 2; ++k)
      if (const double even = sums[k] / static_cast<double>(counts.size()); even > 0)
        plot.series[k].points.push_back(
            {x, both[k] / even, conditional ? 0 : kMost * std::sqrt(both[k]) / even});
  return plot;
}

Plot Exits::plot_of_places() const {
  return plot_by("Where along the holes orbits leave", "hole after hole, share of its length",
                 [](std::size_t hole, std::size_t place, std::size_t) {
                   return static_cast<double>(hole) + (static_cast<double>(place) + 0.5) / kCells;
                 });
}

Plot Exits::plot_of_sines() const {
  return plot_by("Under which angle orbits leave",
                 "sine of the angle to the hole's normal, positive along the walls",
                 [](std::size_t, std::size_t, std::size_t sine) {
                   return 2 * (static_cast<double>(sine) + 0.5) / kCells - 1;
                 });
}

}  // namespace flatray
