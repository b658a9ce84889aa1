#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "study/plots/plot.h"
#include "study/rooms/boundary_orbits.h"
#include "study/statistics/estimate.h"

namespace flatray::phase_portion_experiment {
namespace {

constexpr std::uint64_t kRandomOrbits = 8;
constexpr int kCells = 100;  // along the walls, and of the sine

// Shares of the cells an orbit has come to, after 1, 2, 4, ... bounces and all of them.
class Portions {
 public:
  void see(const BoundaryPoint& point) {
    const int x = std::clamp(static_cast<int>(point.along * kCells), 0, kCells - 1);
    const int y = std::clamp(static_cast<int>((1 + point.sine) * 0.5 * kCells), 0, kCells - 1);
    const auto cell = static_cast<std::size_t>(y) * kCells + static_cast<std::size_t>(x);
    if (!seen_[cell]) ++count_;
    seen_[cell] = true;
    if (++bounces_ < next_) return;
    add_to(curve_);
    next_ = std::ceil(next_ * 1.25);
  }
  Numbers numbers() const {
    Numbers all = curve_;
    if (bounces_ > 0 && all[all.size() - 2] != bounces_) add_to(all);
    return all;
  }

 private:
  void add_to(Numbers& curve) const {
    curve.insert(curve.end(), {bounces_, count_ / (kCells * kCells)});
  }
  std::vector<bool> seen_ = std::vector<bool>(kCells * kCells);
  Numbers curve_;
  double count_ = 0, next_ = 1, bounces_ = 0;
};

// What bounces come to that are independent and uniform.
double filled(double bounces) { return 1 - portable::exp(-bounces / (kCells * kCells)); }

Result<ExperimentResult> run(const ExperimentContext& context) {
  if (auto closed = expect_closed(context); !closed) return fail(std::move(closed));
  const Room room(context.scene);
  FLATRAY_TRY(orbits, boundary_orbits(context, room, kRandomOrbits));
  Plot plot{"Part of phase space an orbit comes to", "bounces", "portion of the cells"};
  std::vector<Measure> measures;
  const auto audit = watch_bounces(
      context, room, *orbits, Portions(), [&](std::size_t orbit, std::span<const double> curve) {
        Plot::Series& series = plot.series.emplace_back(Plot::Series{orbits->orbits.names[orbit]});
        for (std::size_t i = 0; i < curve.size(); i += 2)
          series.points.push_back({curve[i], curve[i + 1]});
        measures.push_back({series.name, curve.empty() ? 0 : curve.back()});
      });
  if (!audit) return tl::unexpected(audit.error());
  if (!plot.series.empty()) {
    Plot::Series even{"if it came everywhere alike"};
    for (const Plot::Point& point : plot.series.front().points)
      even.points.push_back({point.x, filled(point.x)});
    if (!even.points.empty()) measures.push_back({"if_everywhere_alike", even.points.back().y});
    plot.series.push_back(std::move(even));
  }
  ExperimentResult result =
      measured(context, "phase_portion",
               fmt::format("Part of {} x {} cells of walls and sines that each orbit comes to",
                           kCells, kCells),
               std::move(measures), *audit);
  result.files.push_back({"phase_portion.svg", svg(plot)});
  return result;
}

}  // namespace

extern const Experiment entry = {"phase-portion", "How much of phase space does one orbit come to?",
                                 &run, kUsesOfOrbitMeans};

}  // namespace flatray::phase_portion_experiment
