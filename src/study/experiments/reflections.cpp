
#include <algorithm>

#include "study/rooms/pixel_map.h"
#include "study/rooms/wedge.h"
#include "study/statistics/estimate.h"

namespace flatray::reflections_experiment {
namespace {

// Usual limits: of a map in a room that keeps every ray; of a ray, and of one in a wedge, which
// leaves in the end.
constexpr std::uint64_t kPixelBounces = 200, kRayBounces = 1'000'000;
constexpr std::uint64_t kWedgeBounces = std::uint64_t{1} << 30;
constexpr LinearRgb kSolid{0.02, 0.03, 0.08};

struct Counts : OrbitSink {
  void bounce(std::size_t, const Bounce&) override { ++count; }
  void end(std::size_t, const OrbitStop& stop) override { goes_on = stop.end == OrbitEnd::limit; }

  double count = 0;
  bool goes_on = false;
};

// A row for each ray of the scene, with the closed form where its walls are a wedge.
std::vector<Measure> ray_counts(const ExperimentContext& context, const Room& room,
                                const NamedOrbits& orbits) {
  std::vector<Measure> measures;
  for (std::size_t i = 0; i < orbits.starts.size(); ++i) {
    const auto known = wedge_reflections(room.walls(), orbits.starts[i].ray);
    Counts counts;
    room.orbits().follow(std::span(&orbits.starts[i], 1),
                         context.bounces.value_or(known ? kWedgeBounces : kRayBounces), counts);
    measures.push_back({orbits.names[i] + (counts.goes_on ? " (at least)" : ""), counts.count});
    if (!known || counts.goes_on) continue;
    measures.back().expected = static_cast<double>(*known);
    measures.back().allowed = 0;
  }
  return measures;
}

// Brightness by the logarithm of the count.
Plot plot_of(const ExperimentContext& context, const Room& room,
             const std::vector<PixelOutcome>& pixels) {
  std::uint32_t most = 0;
  for (const PixelOutcome& pixel : pixels) most = std::max(most, pixel.bounces);
  const auto part = [&](double bounces) { return log_share(bounces, most); };
  Plot plot = pixel_plot(context, room, PixelMap::position, [&](std::size_t i) {
    return pixels[i].kind == PixelOutcome::Kind::solid ? kSolid : heat(part(pixels[i].bounces));
  });
  plot.title = "How often a ray is reflected, by its start";
  plot.bar = bar_of("reflections", most, &heat, part);
  plot.kinds.emplace_back(hex(kSolid), "starts in an obstacle, or outside");
  return plot;
}

Result<ExperimentResult> run(const ExperimentContext& context) {
  const Room room(context.scene);
  FLATRAY_TRY(orbits, orbits_to_watch(context, room, 0));
  FLATRAY_TRY(pixels, trace_pixels(context, room, context.bounces.value_or(kPixelBounces),
                                   PixelMap::position));
  std::vector<Measure> measures = ray_counts(context, room, *orbits);
  double sum = 0, free = 0, most = 0;
  for (const PixelOutcome& pixel : *pixels) {
    if (pixel.kind == PixelOutcome::Kind::solid) continue;
    sum += pixel.bounces;
    ++free;
    most = std::max(most, static_cast<double>(pixel.bounces));
  }
  if (free > 0) {
    // Pixels on one line of the direction are one orbit: what they differ by tells no error.
    measures.push_back(remarked("pixels_mean", sum / free, "of these pixels, counted"));
    measures.push_back({"pixels_most", most});
  }
  ExperimentResult result = measured(
      context, "reflections",
      "Reflections of the scene's rays, and of a ray in the direction of the first from each pixel",
      std::move(measures));
  add_map(result, "reflections", plot_of(context, room, *pixels), context.threads,
          [&](std::size_t i) { return bounces_text((*pixels)[i]); });
  return result;
}

}  // namespace

extern const Experiment entry = {"reflections",
                                 "How often is a ray reflected, from every pixel and of every ray?",
                                 &run,
                                 {.bounces = true, .map = true, .resume = true}};

}  // namespace flatray::reflections_experiment
