#include <fmt/core.h>

#include <cmath>

#include "base/counted.h"
#include "study/plots/line_density.h"
#include "study/plots/plot.h"
#include "study/rooms/room.h"
#include "study/statistics/blocks.h"
#include "study/statistics/estimate.h"

namespace flatray::coverage_experiment {
namespace {

constexpr std::uint64_t kBounces = 10'000;
constexpr int kCells = 160;  // along the longer side of the window

struct Grid {
  int width, height;
  std::vector<bool> free;  // by cell: whether its centre lies in the room
  double count = 0;        // of those
};

Grid grid_of(const Room& room) {
  const Bounds& window = room.state().window;
  const double longer = window.size().maxCoeff() / kCells;
  Grid grid{std::max(1, static_cast<int>(std::floor(window.size().x() / longer + 0.5))),
            std::max(1, static_cast<int>(std::floor(window.size().y() / longer + 0.5))),
            {}};
  for (int y = 0; y < grid.height; ++y)
    for (int x = 0; x < grid.width; ++x) {
      const Vec2 centre = window.low + Vec2((x + 0.5) / grid.width * window.size().x(),
                                            (y + 0.5) / grid.height * window.size().y());
      grid.free.push_back(room.solids().in_chamber(centre) && !room.solids().holder(centre));
      grid.count += grid.free.back() ? 1 : 0;
    }
  return grid;
}

// Cells whose centre lies in the room that one path has crossed.
class Crossed : public OrbitSink {
 public:
  Crossed(const Room& room, const Grid& grid, const Vec2& start)
      : grid_(grid), density_(room.state().window, grid.width, grid.height), last_(start) {}

  void bounce(std::size_t, const Bounce& bounce) override {
    density_.add(last_, bounce.point);
    last_ = bounce.point;
    if (++bounces_ < next_) return;
    note();
    next_ += (next_ + 3) / 4;
  }
  void cross(std::size_t, const Vec2& from, const Vec2& to, const CellIndex&) override {
    density_.add(last_, from);
    last_ = to;
  }
  void end(std::size_t, const OrbitStop& stop) override {
    if (stop.end == OrbitEnd::absorbed || stop.end == OrbitEnd::corner)
      density_.add(last_, stop.end_point);
    if (curve_.empty() || curve_[curve_.size() - 2] < static_cast<double>(bounces_)) note();
  }
  /// Pairs of bounces and cells crossed, then the density.
  Numbers numbers() const {
    Numbers all{static_cast<double>(curve_.size())};
    all.insert(all.end(), curve_.begin(), curve_.end());
    all.insert(all.end(), density_.cells().begin(), density_.cells().end());
    return all;
  }

 private:
  void note() {
    double crossed = 0;
    for (std::size_t i = 0; i < grid_.free.size(); ++i)
      crossed += grid_.free[i] && density_.cells()[i] > 0 ? 1 : 0;
    curve_.insert(curve_.end(), {static_cast<double>(bounces_), crossed});
  }
  const Grid& grid_;
  LineDensity density_;
  Vec2 last_;
  std::uint64_t bounces_ = 0, next_ = 1;
  Numbers curve_;
};

Result<ExperimentResult> run(const ExperimentContext& context) {
  const Room room(context.scene);
  FLATRAY_TRY(watched, orbits_to_watch(context, room, 1));
  const Grid grid = grid_of(room);
  const std::uint64_t bounces = context.bounces.value_or(kBounces);
  FLATRAY_TRY(found, run_blocks(context, watched->starts.size(), [&](std::size_t i) {
                Crossed crossed(room, grid, watched->starts[i].ray.origin);
                room.orbits().follow(std::span(&watched->starts[i], 1), bounces, crossed);
                return crossed.numbers();
              }));
  Plot plot{"Part of the room a path has crossed", "bounces", "portion of the cells"};
  std::vector<Measure> measures;
  for (std::size_t i = 0; i < found->size(); ++i) {
    Plot::Series& series = plot.series.emplace_back(Plot::Series{watched->names[i]});
    const Numbers& numbers = (*found)[i];
    for (std::size_t k = 1; k < 1 + static_cast<std::size_t>(numbers.front()); k += 2)
      series.points.push_back({numbers[k], numbers[k + 1] / grid.count});
    measures.push_back({watched->names[i], series.points.back().y});
  }
  ExperimentResult result = measured(
      context, "coverage",
      fmt::format(
          "Part of {} x {} cells, of the {:.0f} whose centre lies in the room, that each path "
          "crosses in {}",
          grid.width, grid.height, grid.count, counted(bounces, "bounce")),
      std::move(measures));
  result.files.push_back({"coverage.svg", svg(plot)});
  return result;
}

}  // namespace

extern const Experiment entry = {"coverage",
                                 "How much of the room does one path cross?",
                                 &run,
                                 {.bounces = true, .seed = true, .resume = true}};

}  // namespace flatray::coverage_experiment
