#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "base/portable_math.h"
#include "base/table.h"
#include "precise/certified_orbit.h"
#include "precise/proven_bounces.h"
#include "study/plots/plot.h"
#include "study/rooms/room.h"
#include "study/statistics/estimate.h"
#include "study/statistics/line_fit.h"

namespace flatray::divergence_experiment {
namespace {

constexpr std::uint64_t kBounces = 200;
constexpr std::uint64_t kRandomOrbits = 16;

// One orbit three times: without error, beside itself, and in doubles.
struct Trio {
  CertifiedOrbit exact, beside;
  Orbit plain;
};

Result<Trio> trace(const Room& room, const Ray& start, std::uint64_t bounces, double apart) {
  const Vec2 along = unit(start.direction);
  const Ray moved{start.origin + apart * Vec2(-along.y(), along.x()), start.direction};
  if (moved.origin == start.origin)
    return refused_option("--apart",
                          fmt::format("{:.17g} is less than doubles tell at the start", apart),
                          "say a larger one, as 1e-9");
  const CertifiedRules rules{room.materials()};
  FLATRAY_TRY(exact, certified_orbit(room.walls(), start, bounces, rules));
  FLATRAY_TRY(beside, certified_orbit(room.walls(), moved, bounces, rules));
  return Trio{std::move(*exact), std::move(*beside),
              trace_orbit(room.walls(), room.materials(), start, bounces)};
}

// Off the wall that a random orbit starts on, so that its neighbour is not beyond it.
struct FirstPoint : OrbitSink {
  void bounce(std::size_t, const Bounce& bounce) override { point = point.value_or(bounce.point); }
  void cross(std::size_t, const Vec2& from, const Vec2&, const CellIndex&) override {
    point = point.value_or(from);
  }

  std::optional<Vec2> point;
};

Ray half_way(const Room& room, const OrbitStart& start) {
  FirstPoint first;
  room.orbits().follow(std::span(&start, 1), 1, first);
  const Vec2& origin = start.ray.origin;
  return {0.5 * origin + 0.5 * first.point.value_or(origin), start.ray.direction};
}

class Study {
 public:
  Study(const ExperimentContext& context, const Room& room)
      : context_(context), room_(room), size_(bounds_of(room.walls()).size().maxCoeff()) {}

  void add(const std::string& name, const Trio& trio) {
    ++starts_;
    const std::uint64_t proven =
        proven_bounces(room_.walls(), trio.plain, room_.materials()).bounces;
    const std::size_t both = std::min(trio.exact.bounces.size(), trio.beside.bounces.size());
    Plot::Series parted{name + ": neighbours"}, error{name + ": doubles"};
    // Of the logarithm of the distance; what the fit leaves is no error of the slope, as it is the
    // same way of one orbit.
    LineFit fit;
    std::uint64_t same = 0;
    bool near = true, right = true;
    for (std::size_t i = 0; i < trio.exact.bounces.size(); ++i) {
      const auto& exact = trio.exact.bounces[i];
      const bool there = i < trio.plain.bounces.size();
      right = right && there && is_same_wall(trio.plain.bounces[i], exact);
      const double off = there ? distance(trio.plain.bounces[i], exact) : size_;
      near = near && i < both && is_same_wall(trio.beside.bounces[i], exact);
      const double apart = i < both ? distance(trio.beside.bounces[i], exact) : size_;
      near = near && apart < kHorizonShare * size_;
      if (near && apart > 0) fit.add(static_cast<double>(i + 1), portable::log(apart));
      if (right) same = i + 1;
      table_.add({name, std::uint64_t{i + 1}, apart, off, right ? "yes" : "no",
                  i < proven ? "yes" : "no"});
      parted.points.push_back({static_cast<double>(i + 1), apart});
      error.points.push_back({static_cast<double>(i + 1), off});
    }
    plot_.series.push_back(std::move(parted));
    plot_.series.push_back(std::move(error));
    const auto bounces = [](std::uint64_t n) { return static_cast<double>(n); };
    measures_.push_back({name + ": doubles within 1 % of the room until bounce",
                         bounces(horizon(room_.walls(), trio.exact, trio.plain.bounces))});
    measures_.push_back({name + ": walls of doubles right until bounce", bounces(same)});
    measures_.push_back({name + ": bounces of doubles proven", bounces(proven)});
    measures_.push_back({name + ": bits of the exact orbit", bounces(trio.exact.bits)});
    if (!(fit.n > 2 && fit.spread() > 0)) return;
    const std::string rate = name + ": growth per bounce";
    if (straight_) {
      measures_.push_back(
          remarked(rate, 0, "all walls are straight: neighbours part like a power"));
      return;
    }
    measures_.push_back({rate, fit.slope()});
    growth_.add(fit.slope(), 1);
  }

  // Where starts are alike by symmetry, as in a circle, they differ by rounding and by `apart`; in
  // open rooms those that stay long enough are no fair draw.
  std::string why_no_error(const Measure& mean) const {
    constexpr double kAlike = 1e-4, kMost = 0.75;
    if (growth_.samples < kMost * static_cast<double>(starts_))
      return fmt::format("no error: only {} of {} starts part for three bounces", growth_.samples,
                         starts_);
    return mean.standard_error && *mean.standard_error <= kAlike * std::fabs(mean.value)
               ? "no error: starts do not differ but by rounding"
               : "";
  }

  ExperimentResult result(bool random) && {
    if (random && growth_.samples > 1) {
      Measure mean = growth_.measure("growth per bounce, mean of starts");
      mean.remark = why_no_error(mean);
      if (mean.remark.empty())
        mean.remark =
            fmt::format("until 1 % of the room apart; error from {} starts", growth_.samples);
      else
        mean.standard_error.reset();
      measures_.push_back(std::move(mean));
    }
    ExperimentResult all = measured(
        context_, "divergence",
        fmt::format("Orbits {} apart at their start, and the error of doubles, beside exact ones",
                    context_.apart),
        std::move(measures_));
    all.files.push_back(csv_file("divergence_bounces", table_));
    all.files.push_back({"divergence.svg", svg(plot_)});
    return all;
  }

 private:
  // In the plane, whichever cells they are in.
  template <class One>
  double distance(const One& one, const CertifiedOrbit::Bounce& other) const {
    return room_.orbits().periodic().shifted(one.point - other.point, one.cell - other.cell).norm();
  }

  const ExperimentContext& context_;
  const Room& room_;
  double size_;
  bool straight_ = room_.walls().curve_numbers.empty();
  RatioSums growth_;
  std::size_t starts_ = 0;
  std::vector<Measure> measures_;
  Table table_{{"orbit", "bounce", "neighbours_apart", "error_of_doubles", "wall_right", "proven"}};
  Plot plot_{"How far orbits have parted", "bounce", "distance, world units", {}, true};
};

Result<ExperimentResult> run(const ExperimentContext& context) {
  const Room room(context.scene);
  FLATRAY_TRY(watched, orbits_to_watch(context, room, kRandomOrbits));
  std::vector<std::optional<Result<Trio>>> trios(watched->starts.size());
  parallel_for(trios.size(), context.threads, [&](std::size_t i) {
    const Ray start = watched->random ? half_way(room, watched->starts[i]) : watched->starts[i].ray;
    trios[i] = trace(room, start, context.bounces.value_or(kBounces), context.apart);
  });
  Study study(context, room);
  for (std::size_t i = 0; i < trios.size(); ++i) {
    if (!*trios[i]) return tl::unexpected(trios[i]->error());
    study.add(watched->names[i], **trios[i]);
  }
  return std::move(study).result(watched->random);
}

}  // namespace

extern const Experiment entry = {
    "divergence",
    "How soon do near orbits part, and until when do doubles know better?",
    &run,
    {.bounces = true, .apart = true, .seed = true, .starts = true}};

}  // namespace flatray::divergence_experiment
