#include "collide/edge_ray_meetings.h"

#include <fmt/core.h>

#include <optional>

#include "collide/broad_phase.h"
#include "geom/box_tree.h"
#include "geom/clip.h"
#include "geom/polygon.h"

namespace flatray {
namespace {

// The convex pieces of an entity where it stands, and which of them are near another.
struct Pieces {
  std::vector<std::vector<Vec2>> rings;
  std::vector<Bounds> boxes;
  BoxTree tree;
};

Pieces pieces(const Shape& shape, const Pose& place) {
  std::vector<std::vector<Vec2>> rings;
  std::vector<Bounds> boxes;
  for (std::size_t piece = 0; piece < shape.piece_count(); ++piece)
    boxes.push_back(box_about(rings.emplace_back(posed_piece(shape, piece, place))));
  return {std::move(rings), boxes, BoxTree(boxes)};
}

bool any_edge_hits(const std::vector<Vec2>& from, const std::vector<Vec2>& against) {
  for (std::size_t i = 0; i < from.size(); ++i)
    if (clip_edge({from[i], edge_end(from, i)}, against)) return true;
  return false;
}

// Each piece of the one that has fewer, against those of the other near it.
bool any_edge_hits(const Pieces& a, const Pieces& b) {
  const Pieces &few = a.rings.size() < b.rings.size() ? a : b, &many = &few == &a ? b : a;
  for (std::size_t i = 0; i < few.rings.size(); ++i)
    for (const std::size_t k : many.tree.near(few.boxes[i]))
      if (any_edge_hits(few.rings[i], many.rings[k]) || any_edge_hits(many.rings[k], few.rings[i]))
        return true;
  return false;
}

}  // namespace

Result<std::vector<Meeting>> find_edge_ray_meetings(const Timeline& timeline, unsigned last_frame) {
  const Scene& scene = timeline.scene();
  constexpr std::size_t most = MeetingLimits().meetings;
  std::vector<bool> resting;
  for (std::uint32_t i = 0; i < scene.entities.size(); ++i) resting.push_back(rests(scene, i));
  std::map<IndexPair, std::vector<MeetingPart>> found;
  for (unsigned frame = 1; frame <= last_frame; ++frame) {
    const std::vector<EntityState> states = entity_states(timeline, frame);
    std::vector<Bounds> boxes;
    std::vector<Pose> poses;
    for (const EntityState& state : states) {
      poses.push_back(pose(state.at, state.angle, state.scale));
      boxes.push_back(shape_bounds(shape_of(scene, state), poses.back()));
    }
    const double time = (frame - 1) / scene.fps;
    std::vector<std::optional<Pieces>> kept(states.size());
    const auto pieces_of = [&](std::uint32_t i) -> const Pieces& {
      if (!kept[i]) kept[i] = pieces(shape_of(scene, states[i]), poses[i]);
      return *kept[i];
    };
    each_overlap(boxes, resting, [&](std::uint32_t a, std::uint32_t b) {
      if (!any_edge_hits(pieces_of(a), pieces_of(b))) return true;
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
  return in_order(found, std::vector<bool>(scene.entities.size(), false));
}

}  // namespace flatray
