#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/counted.h"
#include "base/npy.h"
#include "base/number_text.h"
#include "base/portable_math.h"
#include "study/plots/plot.h"
#include "study/rooms/boundary_orbits.h"
#include "study/statistics/stretches.h"

namespace flatray {
namespace {

constexpr std::uint64_t kRandomOrbits = 64;
constexpr int kWidth = 820, kHeight = 410;  // one to one in the picture of 1000 pixels
constexpr std::size_t kMostNames = 12;

// Light of every point on black: colours tell orbits apart, and add where orbits share a pixel.
Image light_of(const BoundaryOrbits& found) {
  std::vector<Light> sum(static_cast<std::size_t>(kWidth) * kHeight);
  double points = 0;
  for (std::size_t i = 0; i < found.points.size(); ++i)
    for (const BoundaryPoint& point : found.points[i]) {
      const int x = std::clamp(static_cast<int>(point.along * kWidth), 0, kWidth - 1);
      const int y = std::clamp(static_cast<int>((1 - point.sine) * 0.5 * kHeight), 0, kHeight - 1);
      sum[static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)] += nth_colour(i);
      ++points;
    }
  // What a pixel would have if points filled the section evenly is a third of full light; a single
  // point is seen.
  const double scale = std::min(1.0, 0.33 * kWidth * kHeight / std::max(points, 1.0));
  return image_of(kWidth, kHeight, [&](std::size_t i) {
    const double most = std::max({sum[i].r, sum[i].g, sum[i].b});
    if (most == 0) return Light{};
    // All of a pixel by one factor: the colour of an orbit stays its own, however often it comes by.
    const double part = (1 - portable::exp(-2 * scale * most)) / most;
    return Light{part * sum[i].r, part * sum[i].g, part * sum[i].b};
  });
}

Plot plot_of(const BoundaryOrbits& found) {
  Plot plot{"Bounces by place along the walls and angle",
            "place, share of the length of all walls",
            "sine of the angle to the normal",
            {}};
  plot.map.emplace(Plot::Map{light_of(found), {{0, -1}, {1, 1}}});
  if (found.points.size() > kMostNames)
    plot.caption = counted(found.points.size(), "orbit") + ", each in a colour; light adds up";
  else
    for (std::size_t i = 0; i < found.points.size(); ++i)
      plot.kinds.emplace_back(hex(nth_colour(i)), found.orbits.names[i]);
  return plot;
}

// All points, as text and as numbers; of more than ten million every so many.
void add_points(ExperimentResult& result, const BoundaryOrbits& found) {
  constexpr std::uint64_t kMostRows = 10'000'000;
  std::uint64_t all = 0, rows = 0;
  for (const auto& orbit : found.points) all += orbit.size();
  const std::uint64_t every = std::max<std::uint64_t>(1, (all + kMostRows - 1) / kMostRows);
  for (const auto& orbit : found.points) rows += (orbit.size() + every - 1) / every;
  using Kind = NpyTable::Kind;
  NpyTable numbers({{"orbit", Kind::whole},
                    {"bounce", Kind::whole},
                    {"along", Kind::real},
                    {"sine", Kind::real}},
                   rows);
  std::string text = "orbit,bounce,along,sine\n";
  for (std::uint64_t i = 0; i < found.points.size(); ++i)
    for (std::uint64_t k = 0; k < found.points[i].size(); k += every) {
      const BoundaryPoint& point = found.points[i][k];
      text += fmt::format("{},{},{},{}\n", i + 1, k + 1, number_text(point.along),
                          number_text(point.sine));
      numbers.add(i + 1);
      numbers.add(k + 1);
      numbers.add(point.along);
      numbers.add(point.sine);
    }
  result.files.push_back({"poincare_points.csv", std::move(text)});
  result.files.push_back({"poincare_points.npy", std::move(numbers).take()});
}

// Runs of bounces: drawn orbits as they are, independent of each other; orbits asked for in stretches.
std::vector<Stretch> square_sines(const BoundaryOrbits& found) {
  const std::size_t parts =
      found.orbits.random ? 1 : (kStretches + found.points.size() - 1) / found.points.size();
  std::vector<Stretch> all;
  for (const auto& orbit : found.points) {
    const std::size_t here = orbit.size() < parts * kLeastInStretch ? 1 : parts;
    for (std::size_t part = 0; part < here; ++part) {
      const std::size_t begin = part * orbit.size() / here;
      const std::size_t end = (part + 1) * orbit.size() / here;
      double squares = 0;
      for (std::size_t i = begin; i < end; ++i) squares += orbit[i].sine * orbit[i].sine;
      if (end > begin) all.push_back({squares, static_cast<double>(end - begin)});
    }
  }
  return all;
}

// Whether an orbit comes round to the same bounces for ever, as far as doubles are rounded, and without
// drift.
bool is_closed(const std::vector<BoundaryPoint>& points) {
  const auto is_near = [](const BoundaryPoint& a, const BoundaryPoint& b) {
    constexpr double kNear = 0x1p-22;  // far below what is seen, far above rounding
    return std::fabs(a.along - b.along) <= kNear && std::fabs(a.sine - b.sine) <= kNear;
  };
  std::size_t round = 1;
  while (round < points.size() && !is_near(points[round], points[0])) ++round;
  for (std::size_t i = round; i < points.size(); ++i)
    if (!is_near(points[i], points[i % round])) return false;
  return 2 * round <= points.size();
}

// Random starts have the measure that reflection keeps, in which the sine is uniform: the mean of
// its square is 1/3 in every room, whatever orbits do there.
Measure mean_square_sine(const BoundaryOrbits& found) {
  const std::vector<Stretch> stretches = square_sines(found);
  if (!found.orbits.random) {
    Measure measure = measure_of_run("mean_square_sine", stretches);
    const auto closed = std::count_if(found.points.begin(), found.points.end(), &is_closed);
    if (closed == 0) return measure;
    // What stretches of it differ by is rounding, and where they begin.
    measure.standard_error.reset();
    measure.remark = "no error: " +
                     (found.points.size() == 1
                          ? "a closed orbit"
                          : fmt::format("{} of {} orbits are closed", closed, found.points.size()));
    return measure;
  }
  RatioSums sums;
  for (const Stretch& one : stretches) sums.add(one.x, one.y);
  Measure measure = sums.measure("mean_square_sine", 1.0 / 3);
  if (measure.standard_error) measure.remark = fmt::format("error from {} orbits", sums.samples);
  return measure;
}

Result<ExperimentResult> run(const ExperimentContext& context) {
  if (auto closed = expect_closed(context); !closed) return fail(std::move(closed));
  const Room room(context.scene);
  const auto found = boundary_orbits(context, room, kRandomOrbits);
  if (!found) return tl::unexpected(found.error());
  std::vector<Measure> measures{mean_square_sine(*found)};
  measures.insert(measures.end(), found->audit.begin(), found->audit.end());
  ExperimentResult result =
      measured(context, "poincare",
               fmt::format("Bounces of {} by place along the walls and sine of the angle",
                           counted(found->points.size(), "orbit")),
               std::move(measures));
  add_points(result, *found);
  add_plot(result, "poincare", plot_of(*found), context.threads);
  return result;
}

}  // namespace

namespace experiment_entries {
extern const Experiment poincare = {"poincare",
                                    "Where along the walls do orbits bounce, and at which angles?",
                                    &run, kUsesOfOrbitMeans};
}  // namespace experiment_entries

}  // namespace flatray
