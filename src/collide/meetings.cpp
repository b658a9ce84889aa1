#include "collide/meetings.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/parallel.h"
#include "collide/broad_phase.h"
#include "collide/frame_bodies.h"
#include "scene/responses.h"

namespace flatray {
namespace {

std::string called(const Scene& scene, std::uint32_t entity) {
  return called("entity", scene.entities[entity].name, scene.entities[entity].where);
}

// Whether any group it stands in is so.
template <class Is>
bool any_group(const Scene& scene, std::uint32_t entity, const Is& is) {
  for (auto group = scene.entities[entity].group; group; group = scene.groups[*group].group)
    if (is(scene.groups[*group])) return true;
  return false;
}

// Whether it or what carries it ever turns.
bool turns(const Scene& scene, std::uint32_t entity) {
  const auto turning = [](const auto& thing) {
    return thing.angular_velocity != 0 || thing.motion.angle ||
           (thing.motion.follow && thing.motion.follow->turn);
  };
  return turning(scene.entities[entity]) || any_group(scene, entity, turning);
}

// Whether any shape it may have, by its states, is so.
template <class Is>
bool any_look(const Scene& scene, std::uint32_t entity, const Is& is) {
  const Entity& e = scene.entities[entity];
  if (is(scene.shapes[e.shape])) return true;
  if (!e.markov) return false;
  for (const std::vector<Look>& state : e.markov->looks)
    for (const Look& look : state)
      if (look.shape && is(scene.shapes[*look.shape])) return true;
  return false;
}

class MeetingFinder {
 public:
  MeetingFinder(const Timeline& timeline, Outline outline, unsigned threads, MeetingLimits limits)
      : timeline_(timeline),
        scene_(timeline.scene()),
        outline_(outline),
        threads_(threads),
        limits_(limits) {
    for (std::uint32_t i = 0; i < scene_.entities.size(); ++i) {
      straight_.push_back(keeps_velocity(scene_, i));
      rests_.push_back(rests(scene_, i));
    }
  }

  Result<std::vector<Meeting>> run(unsigned last_frame) && {
    whole_time(last_frame);
    if (std::ranges::find(straight_, false) != straight_.end()) frame_by_frame(last_frame);
    if (refused_) return tl::unexpected(Diagnostics{*std::move(refused_)});
    return in_order(parts_, straight_);
  }

 private:
  // What keeps its velocity, from the first frame to the last.
  void whole_time(unsigned last_frame) {
    const std::vector<EntityState> states = entity_states(timeline_, 1);
    const Range within{0, (last_frame - 1.0) / scene_.fps};
    std::vector<MovingShape> bodies;
    std::vector<Bounds> boxes;
    for (std::uint32_t i = 0; i < states.size(); ++i) {
      const EntityState& state = states[i];
      bodies.push_back({&shape_of(scene_, state), pose(state.at, state.angle, state.scale),
                        scene_.entities[i].velocity});
      const MovingShape& body = bodies.back();
      boxes.push_back(straight_[i]
                          ? swept(shape_bounds(*body.shape, body.place), body.velocity, within.high)
                          : Bounds{});
    }
    each_batch(boxes, rests_, [&](const std::vector<IndexPair>& pairs) {
      add(pairs, pairs_meet(bodies, pairs, within, threads_, outline_));
    });
  }

  // In the end, what meets where the last frame shows it and is not told yet: of what has not moved, or
  // has just jumped there.
  void frame_by_frame(unsigned last_frame) {
    std::vector<EntityState> now = entity_states(timeline_, 1);
    for (unsigned frame = 1; frame < last_frame && !refused_; ++frame) {
      std::vector<EntityState> next = entity_states(timeline_, frame + 1);
      ask({timeline_, outline_, frame, frame + 1, now, next},
          [](const IndexPair&) { return true; });
      now = std::move(next);
    }
    const double end = (last_frame - 1.0) / scene_.fps;
    ask({timeline_, outline_, last_frame, last_frame, now, now},
        [&](const IndexPair& pair) { return !is_told(pair, end); });
  }

  bool is_told(const IndexPair& pair, double time) const {
    const auto told = parts_.find(pair);
    return told != parts_.end() && told->second.back().times.high >= time;
  }

  // What does not keep its velocity, against everything.
  template <class Asked>
  void ask(const FrameBodies& bodies, const Asked& is_asked) {
    each_batch(bodies.boxes(), straight_, [&](const std::vector<IndexPair>& pairs) {
      std::vector<IndexPair> together, others;
      for (const IndexPair& pair : pairs)
        if (is_asked(pair)) (bodies.are_straight(pair) ? together : others).push_back(pair);
      auto straight = pairs_meet(bodies.straight(), together, {0, 1}, threads_);
      for (std::vector<MeetingPart>& parts : straight) bodies.to_seconds(parts);
      add(together, straight);
      std::vector<std::vector<MeetingPart>> met(others.size());
      parallel_for(others.size(), threads_,
                   [&](std::size_t i) { met[i] = bodies.meet(others[i]); });
      add(others, met);
    });
  }

  // Pairs of boxes that overlap, some at a time, so that they take no more memory than the bodies; of
  // more than are looked at in one frame none.
  template <class Ask>
  void each_batch(const std::vector<Bounds>& boxes, const std::vector<bool>& left_out,
                  const Ask& ask) {
    std::uint64_t count = 0;
    each_overlap(boxes, left_out, [&](std::uint32_t a, std::uint32_t) {
      if (++count > limits_.pairs)
        refused_ = too_many_meetings(
            scene_, a,
            fmt::format("{} pairs of entities whose boxes meet in one frame", limits_.pairs));
      return !refused_;
    });
    std::vector<IndexPair> batch;
    const std::size_t most = std::max<std::size_t>(1 << 16, 4 * boxes.size());
    if (refused_) return;
    each_overlap(boxes, left_out, [&](std::uint32_t a, std::uint32_t b) {
      batch.emplace_back(a, b);
      if (batch.size() < most) return true;
      ask(batch);
      batch.clear();
      return !refused_;
    });
    if (!refused_) ask(batch);
  }

  void add(const std::vector<IndexPair>& pairs, const std::vector<std::vector<MeetingPart>>& met) {
    for (std::size_t i = 0; i < pairs.size(); ++i)
      for (const MeetingPart& part : met[i]) add(pairs[i], part);
  }

  // In the order of time; what goes on from one frame to the next is one part.
  void add(const IndexPair& pair, const MeetingPart& part) {
    if (add_part(parts_[pair], part) && ++count_ > limits_.meetings)
      refused_ =
          too_many_meetings(scene_, pair.first, fmt::format("{} meetings", limits_.meetings));
  }

  const Timeline& timeline_;
  const Scene& scene_;
  const Outline outline_;
  const unsigned threads_;
  const MeetingLimits limits_;
  std::vector<bool> straight_, rests_;
  std::map<IndexPair, std::vector<MeetingPart>> parts_;
  std::size_t count_ = 0;  // of them
  std::optional<Diagnostic> refused_;
};

}  // namespace

std::vector<Meeting> in_order(const std::map<IndexPair, std::vector<MeetingPart>>& parts,
                              const std::vector<bool>& straight) {
  std::vector<Meeting> all;
  for (const auto& [pair, times] : parts)
    for (const MeetingPart& part : times)
      all.push_back({pair.first, pair.second, part, straight[pair.first] && straight[pair.second]});
  std::ranges::stable_sort(all, {}, [](const Meeting& met) { return met.part.times.low; });
  return all;
}

bool changes_size(const Scene& scene, std::uint32_t entity) {
  return any_look(scene, entity, [](const Shape& shape) { return shape.changes != kNoEntry; }) ||
         any_group(scene, entity, [](const Group& group) { return bool(group.scale.curve); });
}

std::optional<Diagnostics> refused_meetings(const Scene& scene, Outline outline) {
  Diagnostics problems;
  const auto expect_few_corners = [&](const char* kind, const auto& thing) {
    if (corners_a_frame(scene, thing.motion) > kMostCorners)
      problems.push_back({thing.where,
                          fmt::format("{} passes more than {} corners of its path from one "
                                      "frame to the next",
                                      called(kind, thing.name, thing.where), kMostCorners),
                          "write a lower speed or more frames a second"});
  };
  for (const Group& group : scene.groups) expect_few_corners("group", group);
  for (const Entity& entity : scene.entities) expect_few_corners("entity", entity);
  for (std::uint32_t i = 0; outline == Outline::box && i < scene.entities.size(); ++i)
    if (turns(scene, i) &&
        any_look(scene, i, [](const Shape& shape) { return has_parts_left_out(shape); }))
      problems.push_back({scene.entities[i].where,
                          called(scene, i) +
                              " turns, and has curves other than circles and capsules, or crossing "
                              "outlines: when the box around it meets others is not known",
                          "leave --method out, or give it a shape of polygons and circles"});
  for (std::uint32_t i = 0; i < scene.entities.size(); ++i)
    if (changes_size(scene, i))
      problems.push_back(
          {scene.entities[i].where,
           called(scene, i) + " changes its size: when it meets others is not known",
           "write sizes and scales as numbers, or ask who meets in each frame: flatray collide "
           "--method edge-rays"});
  return problems.empty() ? std::nullopt : std::optional(std::move(problems));
}

Diagnostic too_many_meetings(const Scene& scene, std::uint32_t entity, std::string what) {
  return {scene.entities[entity].where,
          fmt::format("there are more than {}, one of them of {}", what, called(scene, entity)),
          "leave out what meets all the others, or say a lower --last"};
}

bool keeps_velocity(const Scene& scene, std::uint32_t entity) {
  const Entity& e = scene.entities[entity];
  if (e.markov || e.motion.any() || e.angular_velocity != 0 || changes_size(scene, entity))
    return false;
  // In a group velocity is turned with it: only what rests is known to move straight.
  return !e.group || (e.velocity.isZero(0) && stands_still(scene, e.group));
}

bool is_left_out(const Scene& scene, std::uint32_t entity) {
  return any_look(scene, entity,
                  [](const Shape& shape) { return has_parts_left_out(shape, true); });
}

bool rests(const Scene& scene, std::uint32_t entity) {
  return keeps_velocity(scene, entity) && scene.entities[entity].velocity.isZero(0);
}

Result<std::vector<Meeting>> find_meetings(const Timeline& timeline, unsigned last_frame,
                                           Outline outline, unsigned threads,
                                           MeetingLimits limits) {
  return MeetingFinder(timeline, outline, threads, limits).run(last_frame);
}

}  // namespace flatray
