#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "study/plots/plot.h"
#include "study/rooms/boundary_orbits.h"
#include "study/statistics/estimate.h"

namespace flatray {
namespace {

constexpr std::uint64_t kRandomOrbits = 8;
constexpr int kCells = 100;  // along the walls, and of the sine

// Shares of the cells an orbit has come to, after 1, 2, 4, ... bounces and all of them.
std::vector<Plot::Point> portions(const std::vector<BoundaryPoint>& points) {
  std::vector<bool> seen(kCells * kCells);
  std::vector<Plot::Point> curve;
  double count = 0, next = 1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const int x = std::clamp(static_cast<int>(points[i].along * kCells), 0, kCells - 1);
    const int y = std::clamp(static_cast<int>((1 + points[i].sine) * 0.5 * kCells), 0, kCells - 1);
    const auto cell = static_cast<std::size_t>(y) * kCells + static_cast<std::size_t>(x);
    if (!seen[cell]) ++count;
    seen[cell] = true;
    const auto bounces = static_cast<double>(i + 1);
    if (bounces < next && i + 1 < points.size()) continue;
    curve.push_back({bounces, count / (kCells * kCells)});
    next = std::ceil(next * 1.25);
  }
  return curve;
}

// What bounces come to that are independent and uniform.
double filled(double bounces) { return 1 - portable::exp(-bounces / (kCells * kCells)); }

Result<ExperimentResult> run(const ExperimentContext& context) {
  if (auto closed = expect_closed(context); !closed) return fail(std::move(closed));
  const Room room(context.scene);
  const auto found = boundary_orbits(context, room, kRandomOrbits);
  if (!found) return tl::unexpected(found.error());
  Plot plot{"Part of phase space an orbit comes to", "bounces", "portion of the cells", {}};
  std::vector<Measure> measures;
  for (std::size_t i = 0; i < found->points.size(); ++i) {
    plot.series.push_back({found->orbits.names[i], portions(found->points[i])});
    const auto& curve = plot.series.back().points;
    measures.push_back({found->orbits.names[i], curve.empty() ? 0 : curve.back().y});
  }
  if (!plot.series.empty()) {
    Plot::Series even{"if it came everywhere alike", {}};
    for (const Plot::Point& point : plot.series.front().points)
      even.points.push_back({point.x, filled(point.x)});
    if (!even.points.empty()) measures.push_back({"if_everywhere_alike", even.points.back().y});
    plot.series.push_back(std::move(even));
  }
  measures.insert(measures.end(), found->audit.begin(), found->audit.end());
  ExperimentResult result =
      measured(context, "phase_portion",
               fmt::format("Part of {} x {} cells of walls and sines that each orbit comes to",
                           kCells, kCells),
               std::move(measures));
  result.files.push_back({"phase_portion.svg", svg(plot)});
  return result;
}

}  // namespace

namespace experiment_entries {
extern const Experiment phase_portion = {
    "phase-portion", "How much of phase space does one orbit come to?", &run, kUsesOfOrbitMeans};
}  // namespace experiment_entries

}  // namespace flatray
