#include "collide/outline_contact.h"

#include <algorithm>

namespace flatray {
namespace {

using Ring = std::vector<Vec2>;

// The convex pieces of a shape in the world, its segments among them.
std::vector<Ring> rings(const MovingShape& moving) {
  const Shape& shape = *moving.shape;
  std::vector<Ring> all;
  for (std::size_t i = 0; i < shape.piece_count(); ++i)
    all.push_back(posed_piece(shape, i, moving.place));
  for (const Segment& s : shape.segments) all.push_back({moving.place(s.a), moving.place(s.b)});
  return all;
}

// Where a contact begins: the vertex that meets an edge, and that edge's normal.
void set_place(const Contact& met, const Ring& a, const Vec2& velocity_a, const Ring& b,
               const Vec2& velocity_b, MeetingPart& part) {
  const ContactFeature& feature = met.first;
  if (feature.vertex == kNoEdge) {
    part.point = a.front() + part.times.low * velocity_a;
    part.normal = {0, 0};
    return;
  }
  const Ring &edges = feature.edge_of_a ? a : b, &vertices = feature.edge_of_a ? b : a;
  const Vec2& velocity = feature.edge_of_a ? velocity_b : velocity_a;
  part.point = vertices[static_cast<std::size_t>(feature.vertex)] + part.times.low * velocity;
  const auto i = static_cast<std::size_t>(feature.edge);
  const Vec2 along = edges[(i + 1) % edges.size()] - edges[i];
  const Vec2 across = Vec2(along.y(), -along.x()).normalized();
  // Out of the first shape: against the way in which it is met.
  const Vec2 towards = velocity_a - velocity_b;
  part.normal = across.dot(towards) < 0 ? Vec2(-across) : across;
}

void join(std::vector<MeetingPart>& parts) {
  std::sort(parts.begin(), parts.end(),
            [](const MeetingPart& p, const MeetingPart& q) { return p.times.low < q.times.low; });
  std::size_t kept = 0;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    MeetingPart& last = parts[kept];
    if (parts[i].times.low > last.times.high) {
      parts[++kept] = parts[i];
      continue;
    }
    last.times.high = std::max(last.times.high, parts[i].times.high);
    last.kind = std::max(last.kind, parts[i].kind);
    last.start = std::max(last.start, parts[i].start);
  }
  if (!parts.empty()) parts.resize(kept + 1);
}

}  // namespace

std::vector<MeetingPart> shapes_meet(const MovingShape& a, const MovingShape& b, Range within) {
  std::vector<MeetingPart> parts;
  const std::vector<Ring> rings_a = rings(a), rings_b = rings(b);
  for (const Ring& p : rings_a)
    for (const Ring& q : rings_b) {
      const Contact met = contact({p, a.velocity}, {q, b.velocity}, within);
      if (!met.times) continue;
      MeetingPart part{
          {met.times.t_enter, met.times.t_exit}, met.times.kind, met.times.start, {0, 0}, {0, 0}};
      set_place(met, p, a.velocity, q, b.velocity, part);
      parts.push_back(part);
    }
  join(parts);
  return parts;
}

bool has_parts_left_out(const Shape& shape) {
  return !shape.circles.empty() || !shape.arc_paths.empty() || !shape.crossing_rings.empty();
}

}  // namespace flatray
