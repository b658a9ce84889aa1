#include "collide/outline_contact.h"

#include <algorithm>
#include <array>

#include "anim/world.h"
#include "base/parallel.h"
#include "collide/contact_batch.h"
#include "geom/polygon.h"
#include "scene/outlines/rounded.h"

namespace flatray {
namespace {

MeetingPart meeting_part(const Contact& met, const MovingBody& a, const MovingBody& b) {
  const HitInterval& times = met.times;
  const ContactPlace place = first_place(met, a, b);
  return {{times.t_enter, times.t_exit}, times.kind, times.start, place.point, place.normal};
}

// An ellipse without area is a segment.
ShapePart ellipse_part(const Ellipse& curve) {
  if (cross_sign(curve.u, curve.v) != Sign::zero) return {{}, 0, curve};
  const Vec2 reach = curve.u.stableNorm() > curve.v.stableNorm() ? curve.u : curve.v;
  return {{curve.centre - reach, curve.centre + reach}};
}

// Cuts between the convex pieces of an outline are inside it: what has no area and only ever lies on
// cuts overlaps, where contact with each piece alone tells that they touch. `cut`: between its ends.
void count_cut(std::array<Vec2, 2> cut, const Vec2& velocity, const MovingBody& thin, Range within,
               std::vector<MeetingPart>& met) {
  if (is_before(cut[1], cut[0])) std::swap(cut[0], cut[1]);
  const auto& ring = thin.vertices;
  if (!std::ranges::all_of(
          ring, [&](const Vec2& p) { return orientation(cut[0], cut[1], p) == Sign::zero; }))
    return;
  const auto raise = [&](double time, StartPlace start) {
    for (MeetingPart& part : met) {
      if (time < part.times.low || time > part.times.high) continue;
      part.kind = HitClass::through;
      part.start = std::max(part.start, start);
    }
  };
  const auto [low, high] = std::ranges::minmax_element(ring, is_before);
  if (within.low <= 0 && within.high >= 0 && is_before(*low, cut[1]) && is_before(cut[0], *high))
    raise(0, StartPlace::inside);
  if (cross_sign(velocity, thin.velocity, cut[0], cut[1]) != Sign::zero) return;
  // On that line at all times: for a while on the cut, or only at one of its ends.
  const HitInterval times = contact({cut, velocity}, thin, within).times;
  if (times.kind == HitClass::along) raise(times.t_enter, StartPlace::outside);
}

// Parts of a body, and how it moves.
struct MovingParts {
  std::span<const ShapePart> parts;
  const Vec2& velocity;

  MovingBody body(const ShapePart& part) const { return {part.ring, velocity, part.radius}; }
};

void count_cuts(const MovingParts& pieces, const MovingParts& others, Range within,
                std::vector<MeetingPart>& met) {
  for (const auto& [ring, radius, curve, cuts] : pieces.parts)
    for (const std::uint32_t k : cuts)
      for (const ShapePart& part : others.parts)
        if (!has_area(part))
          count_cut({ring[k], ring[(k + 1) % ring.size()]}, pieces.velocity, others.body(part),
                    within, met);
}

// By what contact tells of each part of the one with each of the other, in order.
std::vector<MeetingPart> parts_meet(const MovingParts& a, const MovingParts& b,
                                    const Contact* contact, Range within) {
  std::vector<MeetingPart> met;
  for (const ShapePart& p : a.parts)
    for (const ShapePart& q : b.parts) {
      const Contact& found = *contact++;
      if (p.curve || q.curve) {
        if (const auto part = curved_parts_meet(p, a.velocity, q, b.velocity, within))
          met.push_back(*part);
      } else if (found.times) {
        met.push_back(meeting_part(found, a.body(p), b.body(q)));
      }
    }
  join(met);
  if (met.empty()) return met;
  count_cuts(a, b, within, met);
  count_cuts(b, a, within, met);
  return met;
}

std::vector<Contact> ask(const BodySet& bodies, std::span<const MovingPair> pairs, Range within,
                         unsigned threads) {
  std::vector<Contact> found(pairs.size());
  constexpr std::size_t kBlock = 2048;
  parallel_for((pairs.size() + kBlock - 1) / kBlock, threads, [&](std::size_t block) {
    const std::size_t from = block * kBlock, count = std::min(kBlock, pairs.size() - from);
    contacts(bodies, pairs.subspan(from, count), within, std::span(found).subspan(from, count));
  });
  return found;
}

}  // namespace

bool has_area(const ShapePart& part) {
  return part.curve || part.radius > 0 || ring_orientation(part.ring) != Sign::zero;
}

std::vector<ShapePart> parts_of(const Shape& shape, const Pose& place, Outline outline) {
  std::vector<ShapePart> all;
  if (outline == Outline::box) {
    const Bounds box = shape_extent(shape, place);
    if (!box.empty()) all.push_back({box.corners()});
    return all;
  }
  for (std::size_t i = 0; i < shape.piece_count(); ++i) {
    ShapePart piece{posed_piece(shape, i, place)};
    for (std::uint32_t k = shape.begin[i]; k < shape.begin[i + 1]; ++k)
      if (shape.edges[k] < 0) piece.cuts.push_back(k - shape.begin[i]);
    all.push_back(std::move(piece));
  }
  for (const Segment& s : shape.segments) all.push_back({{place(s.a), place(s.b)}});
  for (const Circle& c : shape.circles) {
    const Circle there = posed(c, place);
    all.push_back({{there.centre}, there.radius});
  }
  for (const ArcPath& path : shape.arc_paths) {
    if (const auto round = rounded_by(path)) {
      ShapePart& part = all.emplace_back();
      part.ring = {place(round->from)};
      if (round->to != round->from) part.ring.push_back(place(round->to));
      part.radius = place.length(round->radius);
    } else if (path.is_ellipse()) {
      all.push_back(ellipse_part(curve_of(path.arcs[0], place)));
    }
  }
  return all;
}

void join(std::vector<MeetingPart>& parts) {
  std::ranges::sort(parts, {}, [](const MeetingPart& part) { return part.times.low; });
  for (const MeetingPart& part : std::exchange(parts, {})) add_part(parts, part);
}

MeetingPart proven_part(Range times, StartPlace start, const ContactPlace& place, double width,
                        bool certain) {
  const HitClass kind = certain ? HitClass::through : HitClass::touch;
  return {times, kind, start, place.point, place.normal, width, certain};
}

bool add_part(std::vector<MeetingPart>& parts, const MeetingPart& next) {
  if (parts.empty() || next.times.low > parts.back().times.high) {
    parts.push_back(next);
    return true;
  }
  MeetingPart& last = parts.back();
  if (!last.certain) {
    last.width = std::max(last.width, next.times.low + next.width - last.times.low);
    last.certain = next.certain;
  }
  last.times.high = std::max(last.times.high, next.times.high);
  last.kind = std::max(last.kind, next.kind);
  if (next.times.low == last.times.low) last.start = std::max(last.start, next.start);
  return false;
}

std::vector<MeetingPart> shapes_meet(const MovingShape& a, const MovingShape& b, Range within,
                                     Outline outline) {
  const MovingShape both[] = {a, b};
  const IndexPair pair(0, 1);
  return pairs_meet(both, {&pair, 1}, within, 1, outline)[0];
}

std::vector<std::vector<MeetingPart>> pairs_meet(std::span<const MovingShape> bodies,
                                                 std::span<const IndexPair> pairs, Range within,
                                                 unsigned threads, Outline outline) {
  std::vector<std::vector<ShapePart>> parts(bodies.size());
  std::vector<std::uint32_t> first(bodies.size());  // number of the first of them in the set
  BodySet set;
  std::vector<MovingPair> asks;
  std::vector<std::size_t> begin;  // of each pair
  for (const auto& [a, b] : pairs) {
    for (const std::uint32_t body : {a, b}) {
      if (!parts[body].empty()) continue;
      parts[body] = parts_of(*bodies[body].shape, bodies[body].place, outline);
      first[body] = static_cast<std::uint32_t>(set.size());
      for (const auto& [ring, radius, curve, cuts] :
           parts[body])  // of an ellipse, asked apart, its centre
        set.add(curve ? std::span(&curve->centre, 1) : std::span(ring), radius);
    }
    begin.push_back(asks.size());
    for (std::uint32_t p = 0; p < parts[a].size(); ++p)
      for (std::uint32_t q = 0; q < parts[b].size(); ++q)
        asks.push_back({first[a] + p, first[b] + q, bodies[a].velocity, bodies[b].velocity});
  }
  const std::vector<Contact> found = ask(set, asks, within, threads);
  std::vector<std::vector<MeetingPart>> met(pairs.size());
  parallel_for(pairs.size(), threads, [&](std::size_t i) {
    const auto [a, b] = pairs[i];
    met[i] = parts_meet({parts[a], bodies[a].velocity}, {parts[b], bodies[b].velocity},
                        found.data() + begin[i], within);
  });
  return met;
}

}  // namespace flatray
