#include "collide/outline_contact.h"

#include <algorithm>
#include <array>

#include "anim/world.h"
#include "base/parallel.h"
#include "collide/contact_batch.h"
#include "collide/outline_contact.h"
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
  if (comes_before(cut[1], cut[0])) std::swap(cut[0], cut[1]);
  const auto& ring = thin.vertices;
  if (!std::all_of(ring.begin(), ring.end(),
                   [&](const Vec2& p) { return orientation(cut[0], cut[1], p) == Sign::zero; }))
    return;
  const auto raise = [&](double time, StartPlace start) {
    for (MeetingPart& part : met) {
      if (time < part.times.low || time > part.times.high) continue;
      part.kind = HitClass::through;
      part.start = std::max(part.start, start);
    }
  };
  const auto [low, high] = std::minmax_element(ring.begin(), ring.end(), comes_before);
  if (within.low <= 0 && within.high >= 0 && comes_before(*low, cut[1]) &&
      comes_before(cut[0], *high))
    raise(0, StartPlace::inside);
  if (cross_sign(velocity, thin.velocity, cut[0], cut[1]) != Sign::zero) return;
  // On that line at all times: for a while on the cut, or only at one of its ends.
  const HitInterval times = contact({cut, velocity}, thin, within).times;
  if (times.kind == HitClass::along) raise(times.t_enter, StartPlace::outside);
}

void count_cuts(std::span<const ShapePart> pieces, const Vec2& velocity,
                std::span<const ShapePart> others, const Vec2& others_velocity, Range within,
                std::vector<MeetingPart>& met) {
  for (const auto& [ring, radius, curve, cuts] : pieces)
    for (const std::uint32_t k : cuts)
      for (const ShapePart& part : others)
        if (!has_area(part))
          count_cut({ring[k], ring[(k + 1) % ring.size()]}, velocity, {part.ring, others_velocity},
                    within, met);
}

// Parts of many bodies, made ready once and asked together.
class ReadyBodies {
 public:
  ReadyBodies(std::span<const MovingShape> bodies, Outline outline)
      : bodies_(bodies), outline_(outline), parts_(bodies.size()), first_(bodies.size()) {}

  // Notes what is to be asked of one more pair.
  void add(std::uint32_t a, std::uint32_t b) {
    begin_.push_back(asks_.size());
    for (const std::uint32_t body : {a, b}) make_ready(body);
    for (std::uint32_t p = 0; p < parts_[a].size(); ++p)
      for (std::uint32_t q = 0; q < parts_[b].size(); ++q)
        asks_.push_back({first_[a] + p, first_[b] + q, bodies_[a].velocity, bodies_[b].velocity});
  }

  void ask(Range within, unsigned threads) {
    found_.resize(asks_.size());
    constexpr std::size_t kBlock = 2048;
    parallel_for((asks_.size() + kBlock - 1) / kBlock, threads, [&](std::size_t block) {
      const std::size_t from = block * kBlock, count = std::min(kBlock, asks_.size() - from);
      contacts(set_, std::span(asks_).subspan(from, count), within,
               std::span(found_).subspan(from, count));
    });
  }

  // Of the pair that was noted as number `k`.
  std::vector<MeetingPart> meetings(std::size_t k, std::uint32_t a, std::uint32_t b,
                                    Range within) const {
    const Vec2 &velocity_a = bodies_[a].velocity, &velocity_b = bodies_[b].velocity;
    std::vector<MeetingPart> met;
    const Contact* contact = found_.data() + begin_[k];
    for (const ShapePart& p : parts_[a])
      for (const ShapePart& q : parts_[b]) {
        const Contact& found = *contact++;
        if (p.curve || q.curve) {
          if (const auto part = curved_parts_meet(p, velocity_a, q, velocity_b, within))
            met.push_back(*part);
        } else if (found.times) {
          met.push_back(
              meeting_part(found, {p.ring, velocity_a, p.radius}, {q.ring, velocity_b, q.radius}));
        }
      }
    join(met);
    if (met.empty()) return met;
    count_cuts(parts_[a], velocity_a, parts_[b], velocity_b, within, met);
    count_cuts(parts_[b], velocity_b, parts_[a], velocity_a, within, met);
    return met;
  }

 private:
  void make_ready(std::uint32_t body) {
    if (!parts_[body].empty()) return;
    parts_[body] = parts_of(*bodies_[body].shape, bodies_[body].place, outline_);
    first_[body] = static_cast<std::uint32_t>(set_.size());
    for (const ShapePart& part : parts_[body]) set_.add(core_of(part), part.radius);
  }
  // Of an ellipse its centre: it is asked something else.
  static std::span<const Vec2> core_of(const ShapePart& part) {
    return part.curve ? std::span(&part.curve->centre, 1) : std::span(part.ring);
  }

  const std::span<const MovingShape> bodies_;
  const Outline outline_;
  std::vector<std::vector<ShapePart>> parts_;  // by body, as far as asked
  std::vector<std::uint32_t> first_;           // the number of the first part of each
  BodySet set_;
  std::vector<MovingPair> asks_;
  std::vector<std::size_t> begin_;  // of the asks of each pair
  std::vector<Contact> found_;
};

}  // namespace

bool has_area(const ShapePart& part) {
  return part.curve || part.radius > 0 || ring_orientation(part.ring) != Sign::zero;
}

std::vector<Vec2> ring_of(const Bounds& box) {
  return {box.low, {box.high.x(), box.low.y()}, box.high, {box.low.x(), box.high.y()}};
}

std::vector<ShapePart> parts_of(const Shape& shape, const Pose& place, Outline outline) {
  std::vector<ShapePart> all;
  if (outline == Outline::box) {
    const Bounds box = shape_bounds(shape, place);
    if (!box.empty()) all.push_back({ring_of(box)});
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
      const double radius = place.length(round->radius);
      if (round->from == round->to)
        all.push_back({{place(round->from)}, radius});
      else
        all.push_back({{place(round->from), place(round->to)}, radius});
    } else if (path.is_ellipse()) {
      all.push_back(ellipse_part(curve_of(path.arcs[0], place)));
    }
  }
  return all;
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
    extend(last, parts[i]);
  }
  if (!parts.empty()) parts.resize(kept + 1);
}

MeetingPart proven_part(Range times, StartPlace start, const ContactPlace& place, double width,
                        bool certain) {
  const HitClass kind = certain ? HitClass::through : HitClass::touch;
  return {times, kind, start, place.point, place.normal, width, certain};
}

void extend(MeetingPart& last, const MeetingPart& next) {
  if (!last.certain) {
    last.width = std::max(last.width, next.times.low + next.width - last.times.low);
    last.certain = next.certain;
  }
  last.times.high = std::max(last.times.high, next.times.high);
  last.kind = std::max(last.kind, next.kind);
  last.start = std::max(last.start, next.start);
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
  ReadyBodies ready(bodies, outline);
  for (const auto& [a, b] : pairs) ready.add(a, b);
  ready.ask(within, threads);
  std::vector<std::vector<MeetingPart>> met(pairs.size());
  parallel_for(pairs.size(), threads, [&](std::size_t i) {
    met[i] = ready.meetings(i, pairs[i].first, pairs[i].second, within);
  });
  return met;
}

}  // namespace flatray
