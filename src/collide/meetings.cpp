#include "collide/meetings.h"

#include <algorithm>
#include <map>

#include "collide/broad_phase.h"

namespace flatray {
namespace {

bool stands_still(const Scene& scene, std::optional<std::uint32_t> group) {
  for (; group; group = scene.groups[*group].group) {
    const Group& g = scene.groups[*group];
    if (g.motion.any() || !g.velocity.isZero(0) || g.angular_velocity != 0) return false;
  }
  return true;
}

Bounds box_of(const MovingShape& moving) { return shape_bounds(*moving.shape, moving.place); }

// Where everything is, for a stretch of time in which motion is straight.
struct Stretch {
  std::vector<MovingShape> bodies;  // by entity; without a shape it plays no part
  Range within;
};

class Search {
 public:
  Search(const Timeline& timeline, Outline outline)
      : timeline_(timeline), scene_(timeline.scene()), outline_(outline) {
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

  const Shape* shape(const EntityState& state) const { return &scene_.shapes[state.shape]; }

  // What keeps its velocity, from the first frame to the last.
  void whole_time(unsigned last_frame) {
    const std::vector<EntityState> states = entity_states(timeline_, 1);
    Stretch stretch{{}, {0, (last_frame - 1.0) / scene_.fps}};
    for (std::uint32_t i = 0; i < states.size(); ++i)
      stretch.bodies.push_back({straight_[i] ? shape(states[i]) : nullptr,
                                pose(states[i].at, states[i].angle, states[i].scale),
                                scene_.entities[i].velocity});
    for (const Pair& pair : close_pairs(stretch)) {
      if (rests_[pair.first] && rests_[pair.second]) continue;
      for (const MeetingPart& part : meet(stretch, pair)) add(pair, part);
    }
  }

  // What does not, against everything, from one frame to the next: t counts frames.
  void one_frame(unsigned frame, const std::vector<EntityState>& now,
                 const std::vector<EntityState>& next) {
    Stretch stretch{{}, {0, 1}};
    for (std::uint32_t i = 0; i < now.size(); ++i)
      stretch.bodies.push_back(
          {shape(now[i]), pose(now[i].at, now[i].angle, now[i].scale), next[i].at - now[i].at});
    for (const Pair& pair : close_pairs(stretch)) {
      if (straight_[pair.first] && straight_[pair.second]) continue;
      for (MeetingPart part : meet(stretch, pair)) {
        part.times.low = (frame - 1 + part.times.low) / scene_.fps;
        part.times.high = (frame - 1 + part.times.high) / scene_.fps;
        add(pair, part);
      }
    }
  }

  std::vector<Pair> close_pairs(const Stretch& stretch) const {
    std::vector<Bounds> boxes;
    for (const MovingShape& body : stretch.bodies)
      boxes.push_back(body.shape == nullptr
                          ? Bounds{}
                          : swept(box_of(body), body.velocity, stretch.within.high));
    return overlapping_pairs(boxes);
  }

  std::vector<MeetingPart> meet(const Stretch& stretch, const Pair& pair) const {
    const MovingShape &a = stretch.bodies[pair.first], &b = stretch.bodies[pair.second];
    return outline_ == Outline::own ? shapes_meet(a, b, stretch.within)
                                    : boxes_meet(a, b, stretch.within);
  }

  // In the order of time; what goes on from one frame to the next is one part.
  void add(const Pair& pair, const MeetingPart& part) {
    std::vector<MeetingPart>& parts = parts_[pair];
    if (parts.empty() || part.times.low > parts.back().times.high) {
      parts.push_back(part);
      return;
    }
    parts.back().times.high = part.times.high;
    parts.back().kind = std::max(parts.back().kind, part.kind);
  }

  const Timeline& timeline_;
  const Scene& scene_;
  const Outline outline_;
  std::vector<bool> straight_, rests_;
  std::map<Pair, std::vector<MeetingPart>> parts_;
};

}  // namespace

bool keeps_velocity(const Scene& scene, std::uint32_t entity) {
  const Entity& e = scene.entities[entity];
  if (e.markov || e.motion.any() || e.angular_velocity != 0) return false;
  // In a group velocity is turned with it: only what rests is known to move straight.
  return !e.group || (e.velocity.isZero(0) && stands_still(scene, e.group));
}

bool rests(const Scene& scene, std::uint32_t entity) {
  return keeps_velocity(scene, entity) && scene.entities[entity].velocity.isZero(0);
}

std::vector<Meeting> find_meetings(const Timeline& timeline, unsigned last_frame, Outline outline) {
  Search search(timeline, outline);
  search.run(last_frame);
  return std::move(search).found();
}

}  // namespace flatray
