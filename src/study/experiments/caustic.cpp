#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/counted.h"
#include "base/portable_math.h"
#include "study/plots/line_density.h"
#include "study/plots/plot.h"
#include "study/rooms/room.h"
#include "study/statistics/blocks.h"
#include "study/statistics/estimate.h"

namespace flatray::caustic_experiment {
namespace {

constexpr std::uint64_t kBounces = 10'000;
constexpr std::size_t kNumbers = 6;  // of a path, before its cells
constexpr int kWide = 640;           // cells of the picture's longer side, where all paths together
constexpr std::size_t kMostCells = std::size_t{1}
                                   << 23;  // have no more than that; else as the film
// What of the distance of a line that keeps it one bounce may round away, in parts of the room's
// extent and of its farthest coordinate: its point is 2 units in the last place off, its direction as many.
constexpr double kRoundingByBounce = 0x1p-50;

// The foci of an ellipse: for conjugate half-diameters u, v the roots of u^2 + v^2 as complex
// numbers lie on them, as seen from the centre.
struct Foci {
  Vec2 one, other;
};
Foci foci_of(const Ellipse& curve) {
  // In units of a power of two, so that fourth powers stay among the doubles.
  const double longest = std::max(curve.u.cwiseAbs().maxCoeff(), curve.v.cwiseAbs().maxCoeff()),
               unit = std::ldexp(1.0, std::ilogb(longest));
  const Vec2 u = curve.u / unit, v = curve.v / unit;
  const double x = u.x() * u.x() - u.y() * u.y() + v.x() * v.x() - v.y() * v.y();
  const double y = 2 * (u.x() * u.y() + v.x() * v.y());
  const double size = std::sqrt(std::sqrt(x * x + y * y));
  const double angle = 0.5 * portable::atan2(y, x);
  const Vec2 reach = unit * size * Vec2(portable::cos(angle), portable::sin(angle));
  return {curve.centre + reach, curve.centre - reach};
}

// The light of one path, how near its lines come to a point, and the product of their signed
// distances to two foci.
class Lines : public OrbitSink {
 public:
  Lines(LineDensity empty, const OrbitStart& start, const Vec2& middle, const Foci& foci)
      : density_(std::move(empty)), middle_(middle), foci_(foci), last_(start.ray.origin) {
    see(start.ray.direction);
  }
  void bounce(std::size_t, const Bounce& bounce) override {
    density_.add(last_, bounce.point);
    last_ = bounce.point;
    see(bounce.out);
  }
  void cross(std::size_t, const Vec2& from, const Vec2& to, const CellIndex&) override {
    density_.add(last_, from);
    last_ = to;
    see(direction_);
  }
  void end(std::size_t, const OrbitStop& stop) override {
    if (stop.end == OrbitEnd::absorbed || stop.end == OrbitEnd::corner)
      density_.add(last_, stop.end_point);
  }
  Numbers numbers() const {
    Numbers all{first_, nearest_, farthest_, first_product_, least_product_, most_product_};
    all.insert(all.end(), density_.cells().begin(), density_.cells().end());
    return all;
  }

 private:
  void see(const Vec2& direction) {
    direction_ = direction;
    const double size = std::sqrt(direction.x() * direction.x() + direction.y() * direction.y());
    const auto distance_to = [&](const Vec2& point) {
      return flatray::cross(Vec2(last_ - point), direction) / size;
    };
    const double distance = std::fabs(distance_to(middle_));
    const double product = distance_to(foci_.one) * distance_to(foci_.other);
    if (nearest_ > farthest_) {
      first_ = distance;
      first_product_ = least_product_ = most_product_ = product;
    }
    nearest_ = std::min(nearest_, distance);
    farthest_ = std::max(farthest_, distance);
    least_product_ = std::min(least_product_, product);
    most_product_ = std::max(most_product_, product);
  }
  LineDensity density_;
  Vec2 middle_;
  Foci foci_;
  Vec2 last_, direction_;
  double first_ = 0, nearest_ = kInfinity, farthest_ = 0;
  double first_product_ = 0, least_product_ = 0, most_product_ = 0;
};

// Cells for one path: a whole number of them for each pixel of the film.
LineDensity empty_density(const Room& room, std::size_t paths) {
  const auto& [width, height] = std::pair(room.scene().film.width, room.scene().film.height);
  int fine = std::max(1, kWide / std::max(width, height));
  const std::size_t all =
      paths * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  while (fine > 1 && all * static_cast<std::size_t>(fine * fine) > kMostCells) --fine;
  return {room.state().window, fine * width, fine * height};
}

Plot plot_of(const Room& room, const LineDensity& density) {
  Plot plot{"Where the lines of the paths lie", "x, world units", "y, world units"};
  plot.map.emplace(Plot::Map{density.picture(), room.state().window});
  const double most = *std::max_element(density.cells().begin(), density.cells().end());
  const auto light = [&](double cell) { return 1 - portable::exp(-density.scale() * cell); };
  if (most > 0)
    plot.bar = bar_of(
        "length of lines, cell widths", most, [&](double part) { return heat(part * light(most)); },
        [&](double cell) { return light(cell) / light(most); });
  return plot;
}

Result<ExperimentResult> run(const ExperimentContext& context) {
  const Room room(context.scene);
  FLATRAY_TRY(watched, orbits_to_watch(context, room, 1));
  const bool elliptic = room.walls().size() == 1 && room.walls().arcs.size() == 1 &&
                        room.walls().arcs.front().extent == Arc::Extent::whole;
  const bool round = elliptic && circle_along(room.walls().arcs.front());
  const Vec2 middle =
      elliptic ? room.walls().arcs.front().curve.centre : Vec2(room.state().window.centre());
  const Foci foci =
      elliptic && !round ? foci_of(room.walls().arcs.front().curve) : Foci{middle, middle};
  const Bounds box = bounds_of(room.walls());
  const double extent = box.size().maxCoeff(),
               farthest = box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs()).maxCoeff();
  const std::uint64_t bounces = context.bounces.value_or(kBounces);
  const double rounding =
      kRoundingByBounce * static_cast<double>(bounces) * std::max(extent, farthest);
  LineDensity all = empty_density(room, watched->starts.size());
  FLATRAY_TRY(found, run_blocks(context, watched->starts.size(), [&](std::size_t i) {
                Lines lines(all, watched->starts[i], middle, foci);
                room.orbits().follow(std::span(&watched->starts[i], 1), bounces, lines);
                return lines.numbers();
              }));
  std::vector<Measure> measures;
  for (std::size_t i = 0; i < found->size(); ++i) {
    const Numbers& one = (*found)[i];
    // In a circle every line of a path is as far from the centre as the first.
    const auto truth = round ? std::optional(one[0]) : std::nullopt;
    const auto add = [&](const char* what, double value, std::optional<double> expected,
                         double allowed) {
      measures.push_back(within_rounding(watched->names[i] + what, value, expected, allowed));
    };
    add(": nearest line to the middle", one[1], truth, rounding);
    add(": farthest line", one[2], truth, rounding);
    // Between the foci of an ellipse it is below 0; lines touch one ellipse or hyperbola with the
    // same foci for ever.
    if (elliptic) {
      add(": least product of distances to the foci", one[4], one[3], rounding * extent);
      add(": largest", one[5], one[3], rounding * extent);
    }
    all.add_cells(std::span(one).subspan(kNumbers));
  }
  ExperimentResult result =
      measured(context, "caustic",
               fmt::format("Distances of the lines of {} from ({:.6g}, {:.6g})",
                           counted(bounces, "bounce"), middle.x(), middle.y()),
               std::move(measures));
  add_map(result, "caustic", plot_of(room, all), context.threads,
          [&](std::size_t i) { return fmt::format("{:.4g}", all.cells()[i]); });
  return result;
}

}  // namespace

extern const Experiment entry = {
    "caustic",
    "What do the lines of a path leave free, and how sharp is its edge?",
    &run,
    {.bounces = true, .seed = true, .resume = true}};

}  // namespace flatray::caustic_experiment
