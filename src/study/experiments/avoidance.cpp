#include <fmt/core.h>

#include <algorithm>

#include "base/number_text.h"
#include "base/table.h"
#include "collide/broad_phase.h"
#include "collide/meetings.h"
#include "scene/names.h"
#include "scene/responses.h"
#include "study/plots/plot.h"
#include "study/statistics/blocks.h"
#include "study/statistics/estimate.h"

namespace flatray::avoidance_experiment {
namespace {

constexpr int kTenths = 10;
constexpr double kFree = -1;
constexpr LinearRgb kClear{0.55, 0.75, 0.9};

// The first entity as it would move to each pixel of the film by the last frame, and what it meets.
class Choices {
 public:
  explicit Choices(const ExperimentContext& context)
      : scene_(context.scene), timeline_(scene_, context.seed, scene_.frames) {
    for (std::uint32_t i = 0; i < scene_.entities.size(); ++i)
      bodies_.push_back(
          {&shape_of(scene_, state_.entities[i]),
           pose(state_.entities[i].at, state_.entities[i].angle, state_.entities[i].scale),
           scene_.entities[i].velocity});
    for (std::size_t i = 1; i < bodies_.size(); ++i)
      boxes_.push_back(
          swept(shape_bounds(*bodies_[i].shape, bodies_[i].place), bodies_[i].velocity, duration_));
  }

  Vec2 velocity(int x, int y) const {
    const Vec2 size = state_.window.size();
    const Vec2 pixel(state_.window.low.x() + (x + 0.5) / scene_.film.width * size.x(),
                     state_.window.high.y() - (y + 0.5) / scene_.film.height * size.y());
    return (pixel - state_.entities[0].at) / duration_;
  }

  // When it first meets another with this velocity; kFree for never.
  double first_time(const Vec2& velocity) const {
    MovingShape mover = bodies_[0];
    mover.velocity = velocity;
    const Bounds box = swept(shape_bounds(*mover.shape, mover.place), velocity, duration_);
    double first = kInfinity;
    for (std::size_t i = 1; i < bodies_.size(); ++i) {
      if (!box.meets(boxes_[i - 1])) continue;
      const auto parts = shapes_meet(mover, bodies_[i], {0, duration_});
      if (!parts.empty()) first = std::min(first, parts.front().times.low);
    }
    return first == kInfinity ? kFree : first;
  }
  double duration() const { return duration_; }
  const Bounds& window() const { return state_.window; }

 private:
  const Scene& scene_;
  const Timeline timeline_;
  const FrameState state_ = at(timeline_, 1);
  const double duration_ = (scene_.frames - 1) / scene_.fps;
  std::vector<MovingShape> bodies_;
  std::vector<Bounds> boxes_;
};

Result<void> expect_movers(const Scene& scene) {
  if (responds(scene)) return tl::unexpected(Diagnostics{refused_responses(scene, "avoidance")});
  if (scene.entities.size() < 2 || scene.frames < 2)
    return fail(scene.where, "avoidance needs two entities and two frames",
                "the first entity is the one that is to choose its velocity");
  for (std::uint32_t i = 0; i < scene.entities.size(); ++i)
    if (!keeps_velocity(scene, i) || has_parts_left_out(scene.shapes[scene.entities[i].shape]))
      return fail(
          scene.entities[i].where,
          "this entity moves otherwise than by one velocity, moves in a group, or has curves",
          "avoidance is for polygons, segments and circles in straight motion");
  return {};
}

Plot plot_of(const ExperimentContext& context, const Choices& choices, const Numbers& times) {
  const Film& film = context.scene.film;
  const double duration = choices.duration();
  const auto colour = [](double part) { return heat(0.1 + 0.6 * part); };
  Plot plot{"When " + entity_name(context.scene, 0) + " first meets another, by where it goes",
            "x of its place by the last frame, world units",
            "y of its place by the last frame, world units"};
  const auto light = [&](std::size_t i) {
    return times[i] == kFree ? kClear : colour(times[i] / duration);
  };
  plot.map.emplace(Plot::Map{image_of(film.width, film.height, light), choices.window()});
  plot.bar = bar_of("first meeting, seconds", duration, colour);
  plot.kinds.emplace_back(hex(kClear), "meets nothing");
  return plot;
}

ExperimentResult results(const ExperimentContext& context, const Choices& choices,
                         const Numbers& times) {
  const Film& film = context.scene.film;
  const double duration = choices.duration();
  std::uint64_t free = 0, by_tenth[kTenths] = {};
  for (const double time : times)
    if (time == kFree)
      ++free;
    else
      ++by_tenth[std::min(kTenths - 1, static_cast<int>(time / duration * kTenths))];
  Table table({"met_before", "velocities"});
  for (int k = 0; k < kTenths; ++k) table.add({(k + 1) * duration / kTenths, by_tenth[k]});
  ExperimentResult result = measured(
      context, "avoidance",
      fmt::format("{} x {} velocities of {}, each to a pixel in {} s", film.width, film.height,
                  entity_name(context.scene, 0), duration),
      {remarked("meets nothing", static_cast<double>(free) / static_cast<double>(times.size()),
                "of these velocities, counted")});
  result.files.push_back(csv_file("avoidance_times", table));
  add_map(result, "avoidance", plot_of(context, choices, times), context.threads,
          [&](std::size_t i) { return times[i] == kFree ? "" : number_text(times[i]); });
  return result;
}

Result<ExperimentResult> run(const ExperimentContext& context) {
  if (auto movers = expect_movers(context.scene); !movers) return fail(std::move(movers));
  const Choices choices(context);
  const Film& film = context.scene.film;
  const auto first_times = [&](std::size_t y) {
    Numbers row;
    for (int x = 0; x < film.width; ++x)
      row.push_back(choices.first_time(choices.velocity(x, static_cast<int>(y))));
    return row;
  };
  Numbers times;
  FLATRAY_TRY(ran, fold_blocks(context, static_cast<std::size_t>(film.height), first_times,
                               [&](const Numbers& row) {
                                 times.insert(times.end(), row.begin(), row.end());
                               }));
  return results(context, choices, times);
}

}  // namespace

extern const Experiment entry = {
    "avoidance",
    "Which velocities of the first entity meet nothing, and when do the others?",
    &run,
    {.resume = true}};

}  // namespace flatray::avoidance_experiment
