#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/counted.h"
#include "base/hash.h"
#include "collide/broad_phase.h"
#include "collide/near_bodies.h"
#include "collide/simulate.h"
#include "scene/responses.h"
#include "study/statistics/stretches.h"

namespace flatray::gas_experiment {
namespace {

// What rounding may come to: an event makes and adds two velocities, each to some units in the last
// place of the fastest; bodies are placed by at + velocity * time, to units of the largest
// coordinate, and lie deeper in each other along a slanting way than across it.
constexpr double kEnergyByEvent = 0x1p-50, kOverlap = 0x1p-40;
constexpr double kEnd = 0x1p40;  // seconds: the count ends it before

// What rests is not moved.
Result<std::vector<SimulatedBody>> gas_bodies(const Timeline& timeline) {
  auto bodies = bodies_of(timeline, Response::bounce, {});
  if (!bodies) return bodies;
  for (std::size_t i = 0; i < bodies->size(); ++i)
    if (timeline.scene().entities[i].velocity.isZero(0)) (*bodies)[i].mass = kInfinity;
  return bodies;
}

// The power of two at or below a size; 1 where there is none.
double power_below(double size) { return size > 0 ? std::ldexp(1.0, std::ilogb(size)) : 1; }

// Of all stages; what its squares are measured in does not count, so they stay near 1.
struct Units {
  double mass, speed;
};
Units units_of(std::span<const SimulatedBody> bodies, const Simulation& done) {
  Units most{0, 0};
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (bodies[i].mass < kInfinity) {
      most.mass = std::max(most.mass, bodies[i].mass);
      for (const Stage& stage : done.stages[i])
        most.speed = std::max(most.speed, stage.velocity.cwiseAbs().maxCoeff());
    }
  return {power_below(most.mass), power_below(most.speed)};
}

double energy(std::span<const SimulatedBody> bodies, const Simulation& done, const Units& units,
              bool first) {
  double sum = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Stage& stage = first ? done.stages[i].front() : done.stages[i].back();
    if (bodies[i].mass < kInfinity)
      sum += 0.5 * (bodies[i].mass / units.mass) * (stage.velocity / units.speed).squaredNorm();
  }
  return sum;
}

// The largest coordinate of bodies at the beginning and at a time.
double largest_coordinate(std::span<const SimulatedBody> bodies, const Simulation& done,
                          double time) {
  double most = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (const Vec2& at : {bodies[i].at, place_at(done.stages[i], time)})
      for (const ShapePart& part : bodies[i].parts)
        for (const Vec2& p : part.ring)
          most = std::max(most, (at + p).cwiseAbs().maxCoeff() + part.radius);
  return most;
}

// A body as it is at a time.
struct PlacedBody {
  std::vector<ShapePart> parts;
  Vec2 velocity;

  PlacedBody(const SimulatedBody& body, const Vec2& at, const Vec2& velocity_now)
      : parts(body.parts), velocity(velocity_now) {
    for (ShapePart& part : parts)
      for (Vec2& p : part.ring) p = at + p;
  }
  // Outward by more than rounding can lose.
  Bounds box() const { return swept(bounds_of(parts), {0, 0}, 0); }
};

// How far two bodies lie in each other, by the shorter way out along their motion; 0 apart.
double depth(const PlacedBody& a, const PlacedBody& b) {
  const double speed = (b.velocity - a.velocity).stableNorm();
  double most = 0;
  for (const ShapePart& p : a.parts)
    for (const ShapePart& q : b.parts) {
      const HitInterval met =
          contact({p.ring, a.velocity, p.radius}, {q.ring, b.velocity, q.radius}, kLine).times;
      if (met.kind == HitClass::through && met.t_enter < 0 && met.t_exit > 0)
        most = std::max(most, speed * std::min(-met.t_enter, met.t_exit));
    }
  return most;
}

double deepest(std::span<const SimulatedBody> bodies, const Simulation& done, double time) {
  std::vector<PlacedBody> now;
  std::vector<Bounds> boxes;
  std::vector<bool> rest;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const std::vector<Stage>& stages = done.stages[i];
    now.emplace_back(bodies[i], place_at(stages, time), stages.back().velocity);
    boxes.push_back(now.back().box());
    rest.push_back(!(bodies[i].mass < kInfinity));
  }
  double most = 0;
  each_overlap(boxes, rest, [&](std::uint32_t a, std::uint32_t b) {
    most = std::max(most, depth(now[a], now[b]));
    return true;
  });
  return most;
}

std::string fingerprint(const Simulation& done) {
  Hash hash;
  const auto add = [&hash](double x) { hash.add(std::bit_cast<std::uint64_t>(x)); };
  for (const CollisionEvent& event : done.events) {
    hash.add(std::uint64_t{event.a}).add(std::uint64_t{event.b});
    add(event.time);
    for (const Vec2& v : {event.point, event.normal, event.velocity_a, event.velocity_b}) {
      add(v.x());
      add(v.y());
    }
  }
  return hash.hex();
}

// Of the whole run, its error from stretches of as many events each.
Measure rate(std::span<const CollisionEvent> events) {
  constexpr std::size_t kLeastEvents = 30;  // of a stretch, for the next one to depend little on it
  const std::size_t count = events.size() < kStretches * kLeastEvents ? std::size_t{1} : kStretches;
  std::vector<Stretch> stretches;
  std::size_t begin = 0;
  double from = 0;
  for (std::size_t i = 1; i <= count; ++i) {
    const std::size_t end = i * events.size() / count;
    const double to = events[end - 1].time;
    stretches.push_back({static_cast<double>(end - begin), to - from});
    begin = end;
    from = to;
  }
  return measure_of_run("events_a_second", stretches);
}

// Where the scene says what entities do that meet, they must bounce.
Result<void> expect_bounces(const Scene& scene) {
  if (!responds(scene)) return {};
  Diagnostics problems;
  for (const Entity& entity : scene.entities)
    if (const Response response = response_of(scene, entity); response != Response::bounce)
      problems.push_back({entity.where,
                          fmt::format("in a gas everything bounces, and the response of {} is {}",
                                      called("entity", entity.name, entity.where), name(response)),
                          "write response = \"bounce\"; flatray collide shows what the scene does",
                          Trouble::invalid});
  if (!problems.empty()) return tl::unexpected(std::move(problems));
  return {};
}

// What nothing moves must rest, or it gives others energy and takes it.
Result<void> expect_rest(const Scene& scene, std::span<const SimulatedBody> bodies) {
  Diagnostics problems;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (const Entity& entity = scene.entities[i];
        bodies[i].mass == kInfinity && !bodies[i].velocity.isZero(0))
      problems.push_back(
          {entity.where,
           fmt::format("in a gas energy is kept, and {} moves though nothing moves it",
                       called("entity", entity.name, entity.where)),
           "let it rest, or give it a mass", Trouble::invalid});
  if (!problems.empty()) return tl::unexpected(std::move(problems));
  return {};
}

Result<ExperimentResult> run(const ExperimentContext& context) {
  if (auto bounces = expect_bounces(context.scene); !bounces) return fail(std::move(bounces));
  const Timeline timeline(context.scene, context.seed, 1);
  FLATRAY_TRY(bodies, gas_bodies(timeline));
  if (auto rest = expect_rest(context.scene, *bodies); !rest) return fail(std::move(rest));
  const Simulation done = simulate(*bodies, kEnd, context.count);
  if (done.events.empty())
    return fail(
        context.scene.entities.empty() ? context.scene.where : context.scene.entities.front().where,
        "nothing ever meets", "give the entities velocities, and walls that keep them in");
  const double time = done.events.back().time;
  const Units units = units_of(*bodies, done);
  const double before = energy(*bodies, done, units, true);
  std::vector<Measure> measures = {
      within_rounding("energy_off", energy(*bodies, done, units, false) / before - 1, 0,
                      kEnergyByEvent * static_cast<double>(done.events.size())),
      within_rounding("deepest_overlap",
                      deepest(*bodies, done, time) / largest_coordinate(*bodies, done, time), 0,
                      kOverlap)};
  if (time > 0) measures.push_back(rate(done.events));
  measures.push_back(expected_within("jammed", done.jammed ? 1.0 : 0.0, 0, 0));
  return measured(
      context, "gas",
      fmt::format("{} of {} in {:.6g} s{}{}; fingerprint of all {}",
                  counted(done.events.size(), "event"), counted(bodies->size(), "body", "bodies"),
                  time, done.complete ? ", after which none meet again" : "",
                  !done.overlaps.empty() ? ", some in each other at the start" : "",
                  fingerprint(done)),
      std::move(measures));
}

}  // namespace

extern const Experiment entry = {
    "gas",
    "What do a million elastic bounces leave of the energy, and do bodies stay apart?",
    &run,
    {.count = true, .seed = true}};

}  // namespace flatray::gas_experiment
