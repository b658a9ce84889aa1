#include "collide/meetings.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "collide/broad_phase.h"
#include "scene/responses.h"
#include "scene/rounded.h"

namespace flatray {
namespace {

// Of what turns a box around all its angles.
Bounds box_of(const MovingShape& moving) {
  if (moving.spin == 0) return shape_bounds(*moving.shape, moving.place);
  Bounds own = shape_bounds(*moving.shape, {{0, 0}, 1, 0, moving.place.scale});
  if (own.empty()) return own;
  const Vec2 farthest = own.low.cwiseAbs().cwiseMax(own.high.cwiseAbs());
  const double reach = (1 + 0x1p-40) * farthest.stableNorm();
  return {moving.place.at - Vec2(reach, reach), moving.place.at + Vec2(reach, reach)};
}

bool turns_with_path(const Scene& scene, std::uint32_t entity) {
  const auto turns = [](const Motion& motion) { return motion.follow && motion.follow->turn; };
  const Entity& e = scene.entities[entity];
  bool any = turns(e.motion);
  for (auto group = e.group; group; group = scene.groups[*group].group)
    any |= turns(scene.groups[*group].motion);
  return any;
}

// Where everything is, for a stretch of time in which motion is straight.
struct Stretch {
  std::vector<MovingShape> bodies;  // by entity; without a shape it plays no part
  Range within;
};

class Search {
 public:
  Search(const Timeline& timeline, Outline outline, unsigned threads)
      : timeline_(timeline), scene_(timeline.scene()), outline_(outline), threads_(threads) {
    for (std::uint32_t i = 0; i < scene_.entities.size(); ++i)
      straight_.push_back(keeps_velocity(scene_, i));
    for (std::uint32_t i = 0; i < scene_.entities.size(); ++i) rests_.push_back(rests(scene_, i));
  }

  void run(unsigned last_frame) {
    whole_time(last_frame);
    if (std::find(straight_.begin(), straight_.end(), false) == straight_.end()) return;
    std::vector<EntityState> now = entity_states(timeline_, 1);
    for (unsigned frame = 1; frame < last_frame; ++frame) {
      std::vector<EntityState> next = entity_states(timeline_, frame + 1);
      one_frame(frame, now, next);
      now = std::move(next);
    }
  }

  std::vector<Meeting> found() && {
    std::vector<Meeting> all;
    for (auto& [pair, parts] : parts_)
      for (const MeetingPart& part : parts)
        all.push_back(
            {pair.first, pair.second, part, straight_[pair.first] && straight_[pair.second]});
    std::stable_sort(all.begin(), all.end(), [](const Meeting& p, const Meeting& q) {
      return p.part.times.low < q.part.times.low;
    });
    return all;
  }

 private:
  using Pair = std::pair<std::uint32_t, std::uint32_t>;

  const Shape* shape(const EntityState& state) const { return &shape_of(scene_, state); }

  // What keeps its velocity, from the first frame to the last.
  void whole_time(unsigned last_frame) {
    const std::vector<EntityState> states = entity_states(timeline_, 1);
    Stretch stretch{{}, {0, (last_frame - 1.0) / scene_.fps}};
    for (std::uint32_t i = 0; i < states.size(); ++i)
      stretch.bodies.push_back({straight_[i] ? shape(states[i]) : nullptr,
                                pose(states[i].at, states[i].angle, states[i].scale),
                                scene_.entities[i].velocity});
    for_meetings(stretch, rests_,
                 [this](const Pair& pair, const MeetingPart& part) { add(pair, part); });
  }

  // What does not, against everything, from one frame to the next: t counts frames.
  void one_frame(unsigned frame, const std::vector<EntityState>& now,
                 const std::vector<EntityState>& next) {
    Stretch stretch{{}, {0, 1}};
    for (std::uint32_t i = 0; i < now.size(); ++i)
      stretch.bodies.push_back({shape(now[i]), pose(now[i].at, now[i].angle, now[i].scale),
                                next[i].at - now[i].at, now[i].angle,
                                turn_between(scene_, i, now[i].angle, next[i].angle)});
    for_meetings(stretch, straight_, [&](const Pair& pair, MeetingPart part) {
      part.times.low = (frame - 1 + part.times.low) / scene_.fps;
      part.times.high = (frame - 1 + part.times.high) / scene_.fps;
      part.width /= scene_.fps;
      add(pair, part);
    });
  }

  std::vector<Pair> close_pairs(const Stretch& stretch) const {
    std::vector<Bounds> boxes;
    for (const MovingShape& body : stretch.bodies)
      boxes.push_back(body.shape == nullptr
                          ? Bounds{}
                          : swept(box_of(body), body.velocity, stretch.within.high));
    return overlapping_pairs(boxes);
  }

  // In the order of the pairs, without those of two that are both left out.
  template <class Take>
  void for_meetings(const Stretch& stretch, const std::vector<bool>& left_out,
                    const Take& take) const {
    std::vector<Pair> pairs = close_pairs(stretch);
    std::erase_if(pairs, [&](const Pair& p) { return left_out[p.first] && left_out[p.second]; });
    if (outline_ == Outline::own) {
      const auto met = pairs_meet(stretch.bodies, pairs, stretch.within, threads_);
      for (std::size_t i = 0; i < pairs.size(); ++i)
        for (const MeetingPart& part : met[i]) take(pairs[i], part);
      return;
    }
    for (const Pair& pair : pairs)
      for (const MeetingPart& part :
           boxes_meet(stretch.bodies[pair.first], stretch.bodies[pair.second], stretch.within))
        take(pair, part);
  }

  // In the order of time; what goes on from one frame to the next is one part.
  void add(const Pair& pair, const MeetingPart& part) {
    std::vector<MeetingPart>& parts = parts_[pair];
    if (parts.empty() || part.times.low > parts.back().times.high) {
      parts.push_back(part);
      return;
    }
    extend(parts.back(), part);
  }

  const Timeline& timeline_;
  const Scene& scene_;
  const Outline outline_;
  const unsigned threads_;
  std::vector<bool> straight_, rests_;
  std::map<Pair, std::vector<MeetingPart>> parts_;
};

}  // namespace

double turn_between(const Scene& scene, std::uint32_t entity, double from, double to) {
  const double turn = to - from;
  if (!turns_with_path(scene, entity)) return turn;
  constexpr double kWhole = 2 * std::numbers::pi;
  return turn - kWhole * std::round(turn / kWhole);
}

bool changes_size(const Scene& scene, std::uint32_t entity) {
  const auto changes = [&](ShapeId shape) { return scene.shapes[shape].changes != kNoEntry; };
  const Entity& e = scene.entities[entity];
  if (changes(e.shape)) return true;
  if (e.markov)
    for (const std::vector<Look>& state : e.markov->looks)
      for (const Look& look : state)
        if (look.shape && changes(*look.shape)) return true;
  for (auto group = e.group; group; group = scene.groups[*group].group)
    if (scene.groups[*group].scale_curve) return true;
  return false;
}

std::optional<Diagnostics> refused_meetings(const Scene& scene) {
  Diagnostics problems;
  for (std::uint32_t i = 0; i < scene.entities.size(); ++i)
    if (changes_size(scene, i))
      problems.push_back(
          {scene.entities[i].where,
           fmt::format("entity '{}' changes its size: when it meets others is not known",
                       scene.entities[i].name),
           "write sizes and scales as numbers, or ask who meets in each frame: flatray collide "
           "--method edge-rays"});
  return problems.empty() ? std::nullopt : std::optional(std::move(problems));
}

bool keeps_velocity(const Scene& scene, std::uint32_t entity) {
  const Entity& e = scene.entities[entity];
  if (e.markov || e.motion.any() || e.angular_velocity != 0 || changes_size(scene, entity))
    return false;
  // In a group velocity is turned with it: only what rests is known to move straight.
  return !e.group || (e.velocity.isZero(0) && stands_still(scene, e.group));
}

bool is_left_out(const Scene& scene, std::uint32_t entity) {
  const Entity& e = scene.entities[entity];
  const Shape& shape = scene.shapes[e.shape];
  if (!has_parts_left_out(shape)) return false;
  if (!shape.crossing_rings.empty()) return true;
  bool turns = e.angular_velocity != 0 || e.motion.angle || turns_with_path(scene, entity);
  for (auto group = e.group; group; group = scene.groups[*group].group)
    turns |= scene.groups[*group].angular_velocity != 0 || scene.groups[*group].motion.angle;
  return turns ||
         !std::all_of(shape.arc_paths.begin(), shape.arc_paths.end(),
                      [](const ArcPath& path) { return path.is_ellipse() || rounded_by(path); });
}

bool rests(const Scene& scene, std::uint32_t entity) {
  return keeps_velocity(scene, entity) && scene.entities[entity].velocity.isZero(0);
}

std::vector<Meeting> find_meetings(const Timeline& timeline, unsigned last_frame, Outline outline,
                                   unsigned threads) {
  Search search(timeline, outline, threads);
  search.run(last_frame);
  return std::move(search).found();
}

}  // namespace flatray
