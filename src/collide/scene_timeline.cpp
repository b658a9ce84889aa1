#include "collide/scene_timeline.h"

#include <fmt/core.h>

#include <algorithm>

#include "collide/simulate.h"
#include "scene/responses.h"

namespace flatray {
Result<void> check_complete(const Scene& scene, const Simulation& done, double last,
                            const Place& where) {
  if (done.until > last) return {};
  const auto name = [&](std::uint32_t i) {
    const std::string& own = scene.entities[i].name;
    return own.empty() ? fmt::format("entity {}", i + 1) : fmt::format("'{}'", own);
  };
  const auto names = [&](std::uint32_t a, std::uint32_t b) {
    return fmt::format("{} and {}", name(a), name(b));
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
                         : fmt::format("{} find no way out at t = {}", jammed, done.jam)),
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
  Result<std::vector<SimulatedBody>> bodies = bodies_of(made.timeline, std::nullopt, {});
  if (!bodies) return fail(std::move(bodies));
  if (std::all_of(bodies->begin(), bodies->end(), [](const SimulatedBody& body) {
        return body.response == Response::none || body.velocity.isZero(0);
      }))
    return made;
  // A frame more, so that what happens at the last one does not hang on how a time is rounded.
  const bool ahead = scene.collisions && scene.collisions->time_bar;
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
  Result<PartTimeline> made = timeline_before_trouble(scene, seed, last_frame);
  if (!made) return fail(std::move(made));
  if (!made->problems.empty()) return tl::unexpected(std::move(made->problems));
  return std::move(made->timeline);
}

}  // namespace flatray
