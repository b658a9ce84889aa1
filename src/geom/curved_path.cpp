// The winding number along a line, as two step functions: of the line moved to its left and to its
// right by less than any number. Where both are inside, the line is; where one is, it runs along the
// boundary. An arc is replaced by the way to its centre and back, and the sector between the two is
// added, which is an intersection of the inside of the curve with at most two half-planes: every end
// is a HitTime, so that all is decided without error.
#include "geom/curved_path.h"

#include <algorithm>
#include <array>
#include <span>

#include "geom/clip.h"
#include "geom/clip_range.h"
#include "geom/exact_hit.h"

namespace flatray {
namespace {

constexpr std::array<Sign, 2> kShifts = {Sign::positive, Sign::negative};  // to the left, right

// At t both winding numbers change, and the line may meet the path in a point.
struct Event {
  HitTime t;
  std::array<int, 2> turns;  // by shift
  int edge;
  bool met;  // a wall is there; else what only stands in for one
};

// Part of the line in a convex set.
struct Stretch {
  HitTime low, high;
  bool empty = false;
};

class Line {
 public:
  explicit Line(const Ray& ray) : ray_(ray) {}

  void add_closed(const PathEdge& edge) {
    touch_vertex(edge.from, edge.number);
    touch_vertex(edge.to, edge.number);
    if (!edge.arc) return cross_edge(edge.from, edge.to, edge.number, true);
    if (edge.from != edge.to) {  // a whole curve, too, whose ends doubles do not tell apart
      const Vec2& centre = edge.arc->curve.centre;
      cross_edge(edge.from, centre, edge.number, false);
      cross_edge(centre, edge.to, edge.number, false);
    }
    add_sectors(*edge.arc, edge.counter_clockwise ? 1 : -1, edge.number);
    touch_arc(*edge.arc, edge.number, true);
  }

  void add_open(const PathEdge& edge) {
    touch_vertex(edge.from, edge.number);
    touch_vertex(edge.to, edge.number);
    if (edge.arc) return touch_arc(*edge.arc, edge.number, false);
    if (side(edge.from) == Sign::zero && side(edge.to) == Sign::zero) {
      Stretch along{abreast(edge.from), abreast(edge.to)};
      if (compare(along.low, along.high) > 0) std::swap(along.low, along.high);
      events_.push_back({along.low, {1, 0}, edge.number, true});
      events_.push_back({along.high, {-1, 0}, edge.number, true});
    } else if (const auto met = hit_segment(ray_, {edge.from, edge.to})) {
      touch(met->t, edge.number);
    }
  }

  std::vector<Event> in_order() && {
    std::stable_sort(events_.begin(), events_.end(),
                     [](const Event& a, const Event& b) { return compare(a.t, b.t) < 0; });
    return std::move(events_);
  }

 private:
  Sign side(const Vec2& p) const { return side_of_ray(ray_, p); }
  HitTime abreast(const Vec2& p) const { return HitTime::abreast(ray_, p); }
  void touch(const HitTime& t, int edge) { events_.push_back({t, {0, 0}, edge, true}); }
  void touch_vertex(const Vec2& p, int edge) {
    if (side(p) == Sign::zero) touch(abreast(p), edge);
  }

  // What is on the line itself is on the other side of a line moved away from it.
  void cross_edge(const Vec2& a, const Vec2& b, int edge, bool met) {
    const Sign from = side(a), to = side(b);
    std::array<int, 2> turns;
    for (std::size_t k = 0; k < kShifts.size(); ++k) {
      const Sign moved_from = from == Sign::zero ? -kShifts[k] : from;
      const Sign moved_to = to == Sign::zero ? -kShifts[k] : to;
      turns[k] = (static_cast<int>(moved_from) - static_cast<int>(moved_to)) / 2;
    }
    if (turns[0] == 0 && turns[1] == 0) return;
    const HitTime t = from == Sign::zero ? abreast(a)
                      : to == Sign::zero ? abreast(b)
                                         : HitTime::on_line(ray_, {a, b});
    events_.push_back({t, turns, edge, met});
  }

  // The sector between an arc and its centre, in parts that are convex.
  void add_sectors(const Arc& arc, int turns, int edge) {
    const auto met = hit_curve(ray_, arc.curve);
    if (!met || met->tangent) return;
    const Stretch inside{met->first, met->second};
    if (arc.extent == Arc::Extent::whole) return add_convex(inside, arc, {}, turns, edge);
    const Vec2& centre = arc.curve.centre;
    const Side from{arc.from, Sign::positive}, before_to{arc.to, Sign::negative};
    switch (orientation(centre, arc.from, arc.to)) {
      case Sign::positive:
        return add_convex(inside, arc, std::array{from, before_to}, turns, edge);
      case Sign::zero:
        return add_convex(inside, arc, std::array{from}, turns, edge);
      case Sign::negative:
        add_convex(inside, arc, std::array{from}, turns, edge);
        add_convex(inside, arc, std::array{Side{arc.from, Sign::negative}, before_to}, turns, edge);
    }
  }

  // The half-plane to one side of the line from the centre to a point.
  struct Side {
    Vec2 towards;
    Sign keep;
  };
  void add_convex(const Stretch& inside, const Arc& arc, std::span<const Side> sides, int turns,
                  int edge) {
    for (std::size_t k = 0; k < kShifts.size(); ++k) {
      Stretch part = inside;
      for (const Side& side : sides) clip(arc.curve.centre, side, kShifts[k], part);
      if (part.empty || compare(part.low, part.high) >= 0) continue;
      const auto add = [&](const HitTime& t, const HitTime& on_curve, int change) {
        Event event{t, {0, 0}, edge, compare(t, on_curve) == 0};
        event.turns[k] = change;
        events_.push_back(event);
      };
      add(part.low, inside.low, turns);
      add(part.high, inside.high, -turns);
    }
  }

  void clip(const Vec2& centre, const Side& side, Sign shift, Stretch& part) const {
    const Sign turn = turn_from_edge(centre, side.towards, ray_.direction) * side.keep;
    if (turn != Sign::zero) {
      const HitTime t = HitTime::on_line(ray_, {centre, side.towards});
      if (turn == Sign::positive && compare(t, part.low) > 0) part.low = t;
      if (turn == Sign::negative && compare(t, part.high) < 0) part.high = t;
      return;
    }
    Sign place = orientation(centre, side.towards, ray_.origin);
    if (place == Sign::zero) {
      const Vec2 left(-ray_.direction.y(), ray_.direction.x());
      place = turn_from_edge(centre, side.towards, left) * shift;
    }
    part.empty |= place != side.keep;
  }

  // Points of an arc that the line may have in common with nothing else of it: of a closed path its
  // tangents and joints, of an open one all.
  void touch_arc(const Arc& arc, int edge, bool tangents_alone) {
    if (arc.extent == Arc::Extent::between)
      for (const Vec2& end : {arc.from, arc.to}) {
        if (const auto t = hit_joint(ray_, arc.curve, end)) touch(*t, edge);
        if (is_on_joint(arc.curve, end, ray_.origin)) touch(abreast(ray_.origin), edge);
      }
    const auto met = hit_curve(ray_, arc.curve);
    if (!met || (tangents_alone && !met->tangent)) return;
    for (const auto root : {Root::first, Root::second})
      if (arc.extent == Arc::Extent::whole ||
          ExactHit(ray_, arc.curve, root).place_in(arc) != PlaceOn::outside)
        touch(root == Root::first ? met->first : met->second, edge);
  }

  Ray ray_;
  std::vector<Event> events_;
};

// Where the two moved lines are between two events.
struct Winding {
  std::array<int, 2> turns{0, 0};
  bool outside() const { return turns[0] == 0 && turns[1] == 0; }
  bool inside() const { return turns[0] != 0 && turns[1] != 0; }
};

// All events at one t.
struct Instant {
  HitTime t;
  Winding before, after;
  int edge = kNoEdge;
  bool met = false;
};

Instant instant_of(std::span<const Event> events, const Winding& before) {
  Instant instant{events.front().t, before, before};
  for (const Event& event : events) {
    for (std::size_t k = 0; k < kShifts.size(); ++k) instant.after.turns[k] += event.turns[k];
    const bool better = event.met == instant.met ? event.edge < instant.edge : event.met;
    if (instant.edge == kNoEdge || better) instant.edge = event.edge;
    instant.met |= event.met;
  }
  return instant;
}

std::vector<Instant> instants_of(std::span<const Event> events) {
  std::vector<Instant> instants;
  Winding winding;
  for (std::size_t begin = 0, end = 0; begin < events.size(); begin = end) {
    while (end < events.size() && compare(events[end].t, events[begin].t) == 0) ++end;
    instants.push_back(instant_of(events.subspan(begin, end - begin), winding));
    winding = instants.back().after;
  }
  return instants;
}

std::vector<LineHit> parts_of(const std::vector<Instant>& instants) {
  std::vector<LineHit> parts;
  for (const Instant& at : instants) {
    if (at.before.outside() && (at.met || !at.after.outside()))
      parts.push_back({at.t, at.t, at.edge, at.edge, HitClass::touch});
    if (parts.empty()) continue;
    if (!at.before.outside()) {
      parts.back().exit = at.t;
      parts.back().edge_exit = at.edge;
    }
    if (at.after.inside()) parts.back().kind = HitClass::through;
    if (!at.after.outside() && parts.back().kind == HitClass::touch)
      parts.back().kind = HitClass::along;
  }
  return parts;
}

StartPlace start_of(const std::vector<Instant>& instants) {
  const auto place = [](const Winding& winding) {
    return winding.inside()    ? StartPlace::inside
           : winding.outside() ? StartPlace::outside
                               : StartPlace::boundary;
  };
  Winding winding;
  for (const Instant& at : instants) {
    if (at.t.sign() == Sign::positive) break;
    winding = at.after;
    if (at.t.sign() != Sign::zero) continue;
    const bool same = place(at.before) == place(at.after);
    return same && !at.met ? place(at.after) : StartPlace::boundary;
  }
  return place(winding);
}

}  // namespace

std::vector<HitInterval> clip_path(const Ray& ray, const CurvedPath& path, Range within) {
  if (path.closed && path.edges.size() == 1 && path.edges.front().arc) {
    const Arc& arc = *path.edges.front().arc;
    if (arc.extent == Arc::Extent::whole) {
      const HitInterval hit = clip_ellipse(ray, arc.curve, within);
      return hit ? std::vector{hit} : std::vector<HitInterval>{};
    }
  }
  const bool point = is_zero(ray.direction);
  Line line(point ? Ray{ray.origin, {1, 0}} : ray);
  for (const PathEdge& edge : path.edges) path.closed ? line.add_closed(edge) : line.add_open(edge);
  const std::vector<Event> events = std::move(line).in_order();
  const std::vector<Instant> instants = instants_of(events);
  const StartPlace start = start_of(instants);
  std::vector<HitInterval> hits;
  const auto add = [&](HitInterval hit) {
    hit.start = start;
    if (hit) hits.push_back(hit);
  };
  if (point)
    add(point_test(start, within));
  else
    for (const LineHit& part : parts_of(instants)) add(clip_to_range(part, within));
  return hits;
}

Bounds bounds_of(const CurvedPath& path) {
  Bounds box;
  for (const PathEdge& edge : path.edges) {
    box.add(edge.from);
    box.add(edge.to);
    if (edge.arc) box.add(curve_bounds(edge.arc->curve));
  }
  return box;
}

}  // namespace flatray
