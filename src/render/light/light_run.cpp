#include "render/light/light_run.h"

#include <algorithm>
#include <bit>
#include <chrono>

#include "render/film_transform.h"
#include "render/light/light_picture.h"
#include "scene/lamp.h"
#include "transport/light/seen_lamps.h"

namespace flatray {
namespace {

using Clock = std::chrono::steady_clock;

// What is needed to follow light in a frame.
struct LitFrame {
  std::vector<World> worlds;  // one, or those of alternatives
  std::vector<const Scatterer*> scatterers;
  std::vector<LampState> lamps;
  FilmPlace place{};

  LitFrame(const Scene& scene, const FrameState& state)
      : worlds(alternative_worlds(scene, state)),
        scatterers(scatterers_of(scene, worlds.front())),
        lamps(lamp_states(scene, state)) {
    const FilmTransform film(scene.film, state);
    place = {film.corner().x(), film.corner().y(), film.scale(), scene.film.width,
             scene.film.height};
  }
};

unsigned noise_frame(const Scene& scene, const FrameState& state) {
  return scene.light.noise_moves ? state.frame : 0;
}

// Where less than this part of the walls is shown, pixels reach lamps sooner than lamps pixels
// (docs/adr/0023-light.md).
constexpr double kSmallPart = 2500;

std::vector<std::vector<std::int64_t>> sums_of_scrambles(const TracedLight& light) {
  std::vector<std::vector<std::int64_t>> sums;
  for (const LightFilm& film : light.films)
    sums.push_back(in_three_channels(film.sums(), film.channels()));
  return sums;
}

// Where it is the aim: after each of the first eight rounds, then after each eighth more: it costs a walk through all
// films. By the number of rounds alone, so that a picture does not hang on when it was interrupted.
bool is_error_due(std::uint64_t rounds) {
  if (rounds == 0) return false;
  return rounds < 8 || rounds % std::max<std::uint64_t>(std::bit_floor(rounds) / 8, 1) == 0;
}

class Rounds {
 public:
  Rounds(const LightGoal& goal, std::uint64_t rays)
      : goal_(goal), end_(rounds_of(rays)), next_(goal.shard), before_(~std::uint64_t{0}) {}

  std::optional<std::uint64_t> operator()(const TracedLight& light) {
    const std::uint64_t count = light.rounds.count();
    std::optional<double> error;
    const bool due =
        goal_.error > 0 ? is_error_due(count) : goal_.told && std::has_single_bit(count);
    const bool measured = due && light.films.size() > 1;
    if (measured) error = relative_error(sums_of_scrambles(light));
    if (before_ < count && goal_.told) goal_.told(light, error);
    before_ = count;
    if (measured && is_reached(error.value_or(0), count)) return std::nullopt;
    const std::chrono::duration<double> time = Clock::now() - start_;
    if (count > 0 && time.count() >= goal_.seconds) return std::nullopt;
    while (next_ < end_ && light.rounds.has(next_)) next_ += goal_.shards;
    if (next_ >= end_) return std::nullopt;
    return std::exchange(next_, next_ + goal_.shards);
  }

 private:
  // Where no light has come by then, none is waited for.
  bool is_reached(double error, std::uint64_t rounds) const {
    constexpr std::uint64_t kDarkRounds = 8;
    return goal_.error > 0 && error <= goal_.error && (error > 0 || rounds >= kDarkRounds);
  }

  const LightGoal& goal_;
  const std::uint64_t end_;
  std::uint64_t next_, before_;
  const Clock::time_point start_ = Clock::now();
};

// Where every lamp is off.
TracedLight darkness(const Scene& scene, TracedLight light, const NextRound& next, bool (*stop)()) {
  while (light.films.size() < scene.light.scrambles)
    light.films.emplace_back(scene.film.width, scene.film.height, light_channels(scene));
  while (const auto round = next(light)) {
    if (stop != nullptr && stop()) {
      light.whole = false;
      break;
    }
    light.rounds.add(*round);
  }
  return light;
}

}  // namespace

LightReport report_of(const TracedLight& light) {
  LightReport report{light.counts, light.rounds.count(), {}, {}, light.film_unit()};
  if (light.films.size() < 2) return report;
  report.scrambles = sums_of_scrambles(light);
  if (report.rounds > 0) report.error = relative_error(report.scrambles);
  return report;
}

TracedLight trace_frame_light(const Scene& scene, const FrameState& state, const Tracer* tracer,
                              std::uint64_t seed, unsigned threads, bool (*stop)(),
                              const LightGoal& goal, TracedLight so_far) {
  const LitFrame lit(scene, state);
  const Rounds rounds(goal, scene.light.rays);
  if (lit.lamps.empty()) return darkness(scene, std::move(so_far), rounds, stop);
  return trace_light(
      lit.worlds, lit.scatterers, lit.lamps, lit.place,
      {scene.light, seed, noise_frame(scene, state), threads, tracer, stop, light_channels(scene)},
      std::move(so_far), rounds);
}

GatheredLight gather_frame_light(const Scene& scene, const FrameState& state, const Tracer* tracer,
                                 std::uint64_t seed, unsigned threads, bool (*stop)()) {
  const LitFrame lit(scene, state);
  return gather_light(lit.worlds.front(), lit.scatterers, lit.lamps, lit.place,
                      {scene.light, seed, noise_frame(scene, state), threads, tracer, stop});
}

bool shows_little(const Scene& scene, const FrameState& state, const Bounds& room, double part) {
  if (room.empty()) return false;
  const FilmTransform film(scene.film, state);
  return part * Vec2(film.scale() * room.size()).prod() >
         kSmallPart * scene.film.width * scene.film.height;
}

bool is_gathered(const Scene& scene, const FrameState& state) {
  if (scene.light.estimator != LightEstimator::automatic)
    return scene.light.estimator == LightEstimator::backward;
  if (why_not_backward(scene) || why_noisy_backward(scene)) return false;
  const World world = build_world(scene, state);
  if (world.surfaces.size() == 0) return false;
  const Bounds all = bounds_of(world.surfaces);
  double part = 1;  // of paths that find the lamp that fewest find
  for (const LampState& lamp : lamp_states(scene, state)) {
    if (!walls_beside(lamp, world.surfaces).walls.empty()) return false;
    part = std::min(part, lamp.emitter->seen_part(all.size().stableNorm() / lamp.pose.scale));
  }
  return shows_little(scene, state, all, part);
}

namespace {

// Light in numbers of a unit: their product may be beyond the doubles.
struct CountedLight {
  std::vector<double> counts;
  double unit;
  LightReport report;
};

CountedLight counted_light(const Scene& scene, const FrameState& state, const Tracer* tracer,
                           std::uint64_t seed, const LightRun& run) {
  if (is_gathered(scene, state)) {
    GatheredLight light = gather_frame_light(scene, state, tracer, seed, run.threads, run.stop);
    LightReport report;
    report.counts.rays = light.paths;
    return {std::move(light.fluence), 1, std::move(report)};
  }
  const LightGoal all;
  const TracedLight light = trace_frame_light(scene, state, tracer, seed, run.threads, run.stop,
                                              run.goal == nullptr ? all : *run.goal);
  const std::vector<std::int64_t> sums = light.sums();
  return {{sums.begin(), sums.end()}, light.unit(), report_of(light)};
}

}  // namespace

std::vector<double> frame_fluence(const Scene& scene, const FrameState& state, const Tracer* tracer,
                                  std::uint64_t seed, const LightRun& run) {
  CountedLight light = counted_light(scene, state, tracer, seed, run);
  for (double& one : light.counts) one *= light.unit;
  return std::move(light.counts);
}

ShownLight show_light(const Timeline& timeline, const FrameState& state, const Tracer* tracer,
                      const LightRun& run) {
  const Scene& scene = timeline.scene();
  CountedLight light = counted_light(scene, state, tracer, timeline.seed(), run);
  return {
      std::make_shared<LightPicture>(light_picture(light.counts, light.unit, scene.light, run.raw)),
      std::move(light.report)};
}

}  // namespace flatray
