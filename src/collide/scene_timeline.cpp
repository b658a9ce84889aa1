#include "collide/scene_timeline.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "anim/motion.h"
#include "collide/near_bodies.h"
#include "collide/simulate.h"
#include "geom/polygon.h"
#include "scene/responses.h"

namespace flatray {
namespace {

std::string called(const Entity& entity) { return called("entity", entity.name, entity.where); }

bool any_area(const std::vector<ShapePart>& parts) { return std::ranges::any_of(parts, has_area); }

// Whether parts have inner points in common wherever they lie together.
bool can_overlap(const ShapePart& p, const ShapePart& q) {
  if (has_area(p) || has_area(q)) return true;
  const auto end = [](const ShapePart& part) {
    return *std::find_if(part.ring.begin(), part.ring.end() - 1,
                         [&](const Vec2& corner) { return corner != part.ring[0]; });
  };
  return cross_sign(p.ring[0], end(p), q.ring[0], end(q)) != Sign::zero;
}

// What contact makes of bodies is found where they overlap: of those that never do, nothing would
// be seen.
void refuse_unseen(const Scene& scene, const std::vector<SimulatedBody>& bodies,
                   Diagnostics& problems) {
  std::vector<std::uint32_t> thin;
  for (std::uint32_t i = 0; i < bodies.size(); ++i)
    if (!bodies[i].parts.empty() && !any_area(bodies[i].parts)) thin.push_back(i);
  for (const std::uint32_t i : thin) {
    if (bodies[i].mass == kInfinity) continue;
    const auto unseen = std::ranges::find_if(thin, [&](std::uint32_t k) {
      if (k == i || (k < i && bodies[k].mass < kInfinity)) return false;  // told with k
      for (const ShapePart& p : bodies[i].parts)
        for (const ShapePart& q : bodies[k].parts)
          if (can_overlap(p, q)) return false;
      return true;
    });
    if (unseen == thin.end()) continue;
    problems.push_back(
        {scene.entities[i].where,
         fmt::format("{} and {} have no area and, wherever they meet, no inner point "
                     "in common: they would pass through each other",
                     called(scene.entities[i]), called(scene.entities[*unseen])),
         "make one of them a disc or a capsule, or write response = \"none\"", Trouble::invalid});
  }
}

double area(const std::vector<ShapePart>& parts, double scale) {
  double sum = 0;
  for (const ShapePart& part : parts) {
    const double radius = scale * part.radius;
    double perimeter = 0;
    std::vector<Vec2> ring;
    for (const Vec2& p : part.ring) ring.emplace_back(scale * p);
    for (std::size_t i = 0; i < ring.size(); ++i) perimeter += (edge_end(ring, i) - ring[i]).norm();
    sum += ring_area(ring) + std::numbers::pi * radius * radius;
    if (radius > 0) sum += perimeter * radius;
  }
  return sum;
}

// Only the proportions of masses count, so where the areas would overflow or be lost lengths are
// scaled by a power of two.
double scale_for(const std::vector<SimulatedBody>& bodies) {
  double most = 0;
  for (const SimulatedBody& body : bodies)
    if (const Bounds box = bounds_of(body.parts); !box.empty())
      most = std::max({most, box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff()});
  constexpr int kUsual = 256, kMost = 1000;
  const int exponent = most > 0 ? std::ilogb(most) : 0;
  return std::abs(exponent) <= kUsual ? 1 : std::ldexp(1.0, -std::clamp(exponent, -kMost, kMost));
}

// A mass given in the file is one beside areas: these are then as they are.
bool any_mass(const Scene& scene) {
  return std::ranges::any_of(scene.entities, [](const Entity& entity) {
    return entity.mass.has_value() && *entity.mass < kInfinity;
  });
}

// Of an entity that says none and is not held; infinite where it has no area.
Result<double> mass_by_area(const Entity& entity, const std::vector<ShapePart>& parts,
                            double scale) {
  if (!any_area(parts)) return kInfinity;
  const double mass = area(parts, scale);
  if (std::isnormal(mass)) return mass;
  return fail(entity.where,
              fmt::format("{} is too {} beside the others for a mass by its area", called(entity),
                          mass < 1 ? "small" : "large"),
              "write a mass, or mass = \"fixed\"");
}

}  // namespace

Result<std::vector<SimulatedBody>> bodies_of(const Timeline& timeline,
                                             std::optional<Response> response,
                                             std::span<const std::string> fixed) {
  const Scene& scene = timeline.scene();
  const std::vector<EntityState> states = entity_states(timeline, 1);
  const std::vector<GroupPose> groups = group_poses(scene, 0);
  std::vector<SimulatedBody> bodies;
  Diagnostics problems;
  for (std::uint32_t i = 0; i < states.size(); ++i) {
    const Entity& entity = scene.entities[i];
    SimulatedBody& body = bodies.emplace_back();
    body.at = states[i].at;
    body.velocity =
        entity.group ? groups[*entity.group].pose.turned(entity.velocity) : entity.velocity;
    body.response = response.value_or(response_of(scene, entity));
    if (body.response == Response::none) continue;
    if (const auto why = hindrance(scene, entity))
      problems.push_back({entity.where, called(entity) + " " + why->what,
                          "responses are for entities that keep one velocity until they meet",
                          Trouble::invalid});
    body.parts =
        parts_of(shape_of(scene, states[i]), pose({0, 0}, states[i].angle, states[i].scale));
  }
  if (!problems.empty()) return tl::unexpected(std::move(problems));
  const double scale = any_mass(scene) ? 1.0 : scale_for(bodies);
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    const Entity& entity = scene.entities[i];
    const bool held = std::ranges::find(fixed, entity.name) != fixed.end();
    Result<double> mass = held          ? kInfinity
                          : entity.mass ? *entity.mass
                                        : mass_by_area(entity, bodies[i].parts, scale);
    if (mass)
      bodies[i].mass = *mass;
    else
      problems.push_back(std::move(mass.error().front()));
  }
  refuse_unseen(scene, bodies, problems);
  if (!problems.empty()) return tl::unexpected(std::move(problems));
  return bodies;
}

Result<void> check_complete(const Scene& scene, const Simulation& done, double last,
                            const Place& where) {
  if (done.until > last) return {};
  const auto names = [&](std::uint32_t a, std::uint32_t b) {
    return fmt::format("{} and {}", called(scene.entities[a]), called(scene.entities[b]));
  };
  const std::string jammed = names(done.untold.first, done.untold.second);
  if (done.crowd > 0)
    return fail(where,
                fmt::format("{} contacts hang together at t = {}, among them that of {}: what they "
                            "make of each other takes more than 2^30 products",
                            done.crowd, done.jam, jammed),
                "place bodies so that fewer lie in each other, or end the sequence before");
  if (done.jammed)
    return fail(where,
                "bodies are jammed: " +
                    (done.jam > done.until
                         ? fmt::format("{} meet faster and faster, without end before t = {:.6g}",
                                       jammed, done.jam)
                         : fmt::format("{} {} at t = {}", jammed,
                                       done.too_often ? "meet again and again" : "find no way out",
                                       done.jam)),
                "give them a way out, or end the sequence before");
  const CollisionEvent& event = done.events.back();
  return fail(where,
              fmt::format("{} events before t = {}, the last of {}", done.events.size(), last,
                          names(event.a, event.b)),
              "end the sequence before, or write a higher most in [collisions]");
}

Result<PartTimeline> timeline_before_trouble(const Scene& scene, std::uint64_t seed,
                                             unsigned last_frame) {
  PartTimeline made{Timeline(scene, seed, last_frame), last_frame, {}};
  if (!responds(scene)) return made;
  FLATRAY_TRY(bodies, bodies_of(made.timeline, std::nullopt, {}));
  if (std::all_of(bodies->begin(), bodies->end(), [](const SimulatedBody& body) {
        return body.response == Response::none || body.velocity.isZero(0);
      }))
    return made;
  // A frame more, so that what happens at the last one does not hang on how a time is rounded.
  // With all frames of the scene where a time bar shows later events, or rays of finite speed meet mirrors:
  // between two events a mirror goes, to the last bit, to where the later event puts it.
  const bool ahead =
      (scene.collisions && scene.collisions->time_bar) ||
      std::ranges::any_of(scene.rays, [](const RayPath& ray) { return ray.speed.has_value(); });
  const unsigned frames = ahead ? std::max(last_frame, scene.frames) : last_frame;
  Simulation done = simulate(*bodies, frames / scene.fps, most_events(scene));
  const auto time_of = [&](unsigned frame) { return (frame - 1.0) / scene.fps; };
  if (auto ended = check_complete(scene, done, time_of(last_frame), where_responds(scene)); !ended)
    made.problems = std::move(ended.error());
  while (made.last_frame > 0 && done.until <= time_of(made.last_frame)) --made.last_frame;
  for (std::uint32_t i = 0; i < bodies->size(); ++i)
    if ((*bodies)[i].response == Response::none) done.stages[i].clear();
  made.timeline = Timeline(scene, seed, std::max(made.last_frame, 1U), std::move(done));
  return made;
}

Result<Timeline> make_timeline(const Scene& scene, std::uint64_t seed, unsigned last_frame) {
  FLATRAY_TRY(made, timeline_before_trouble(scene, seed, last_frame));
  if (!made->problems.empty()) return tl::unexpected(std::move(made->problems));
  return std::move(made->timeline);
}

}  // namespace flatray
