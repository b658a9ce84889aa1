#include "collide/edge_ray_meetings.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "collide/broad_phase.h"
#include "geom/cyrus_beck.h"

namespace flatray {
namespace {

using Entities = std::pair<std::uint32_t, std::uint32_t>;
using Ring = std::vector<Vec2>;

std::vector<Ring> pieces(const Shape& shape, const Pose& place) {
  std::vector<Ring> all;
  for (std::size_t i = 0; i < shape.piece_count(); ++i) all.push_back(posed_piece(shape, i, place));
  return all;
}

bool any_edge_hits(const std::vector<Ring>& from, const std::vector<Ring>& against) {
  for (const Ring& ring : from)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Ray edge{ring[i], ring[(i + 1) % ring.size()] - ring[i]};
      for (const Ring& other : against)
        if (clip_convex(edge, other, kSegment)) return true;
    }
  return false;
}

}  // namespace

Result<std::vector<Meeting>> find_edge_ray_meetings(const Timeline& timeline, unsigned last_frame) {
  const Scene& scene = timeline.scene();
  constexpr std::size_t most = MeetingLimits().meetings;
  std::vector<bool> resting;
  for (std::uint32_t i = 0; i < scene.entities.size(); ++i) resting.push_back(rests(scene, i));
  std::map<Entities, std::vector<MeetingPart>> found;
  for (unsigned frame = 1; frame <= last_frame; ++frame) {
    const std::vector<EntityState> states = entity_states(timeline, frame);
    std::vector<Bounds> boxes;
    std::vector<Pose> poses;
    for (const EntityState& state : states) {
      poses.push_back(pose(state.at, state.angle, state.scale));
      boxes.push_back(shape_bounds(shape_of(scene, state), poses.back()));
    }
    const double time = (frame - 1) / scene.fps;
    each_overlap(boxes, resting, [&](std::uint32_t a, std::uint32_t b) {
      const auto one = pieces(shape_of(scene, states[a]), poses[a]),
                 other = pieces(shape_of(scene, states[b]), poses[b]);
      if (!any_edge_hits(one, other) && !any_edge_hits(other, one)) return true;
      std::vector<MeetingPart>& parts = found[{a, b}];
      const bool goes_on = !parts.empty() && parts.back().times.high == (frame - 2) / scene.fps;
      if (goes_on)
        parts.back().times.high = time;
      else
        parts.push_back({{time, time}, HitClass::through, StartPlace::boundary, {0, 0}, {0, 0}});
      return found.size() <= most;
    });
    if (found.size() > most)
      return tl::unexpected(Diagnostics{
          too_many_meetings(scene, found.begin()->first.first, fmt::format("{} meetings", most))});
  }
  std::vector<Meeting> all;
  for (const auto& [pair, parts] : found)
    for (const MeetingPart& part : parts) all.push_back({pair.first, pair.second, part, false});
  std::stable_sort(all.begin(), all.end(), [](const Meeting& p, const Meeting& q) {
    return p.part.times.low < q.part.times.low;
  });
  return all;
}

}  // namespace flatray
