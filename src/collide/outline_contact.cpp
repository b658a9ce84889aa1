#include "collide/outline_contact.h"

#include <algorithm>

#include "anim/world.h"
#include "base/parallel.h"
#include "collide/carried_contact.h"
#include "collide/contact_batch.h"
#include "collide/ellipse_contact.h"
#include "collide/inner_cuts.h"
#include "scene/rounded.h"

namespace flatray {
namespace {

using Ring = std::vector<Vec2>;

MeetingPart meeting_part(const RoundContact& met, const RoundBody& a, const RoundBody& b) {
  const HitInterval& times = met.times;
  MeetingPart part{{times.t_enter, times.t_exit}, times.kind, times.start, {0, 0}, {0, 0}};
  const RoundPlace place =
      met.first ? place_at(*met.first, a, b, times.t_enter) : resting_place(a, b, part.times.low);
  part.point = place.point;
  part.normal = place.normal;
  return part;
}

// An ellipse without area is a segment.
ShapePart ellipse_part(const Ellipse& curve) {
  if (cross_sign(curve.u, curve.v) != Sign::zero) return {{}, 0, curve};
  const Vec2 reach = curve.u.stableNorm() > curve.v.stableNorm() ? curve.u : curve.v;
  return {{curve.centre - reach, curve.centre + reach}};
}

void add_curved_part(const CurvedBody& a, const CurvedBody& b, Range within,
                     std::vector<MeetingPart>& parts) {
  const CurvedContact met = curved_contact(a, b, within);
  if (met.verdict == CurvedContact::Verdict::apart) return;
  const bool certain = met.verdict == CurvedContact::Verdict::meets;
  parts.push_back({{met.enter.low, met.exit.high},
                   certain ? HitClass::through : HitClass::touch,
                   met.start,
                   met.place.point,
                   met.place.normal,
                   met.enter.high - met.enter.low,
                   certain});
}

std::vector<MeetingPart> parts_meet(const std::vector<ShapePart>& parts_a, const Vec2& velocity_a,
                                    const std::vector<ShapePart>& parts_b, const Vec2& velocity_b,
                                    Range within) {
  std::vector<MeetingPart> parts;
  for (const ShapePart& p : parts_a)
    for (const ShapePart& q : parts_b) {
      const RoundBody one{{p.ring, velocity_a}, p.radius}, other{{q.ring, velocity_b}, q.radius};
      if (p.curve || q.curve) {
        add_curved_part({p.curve, one}, {q.curve, other}, within, parts);
        continue;
      }
      const RoundContact met = round_contact(one, other, within);
      if (met.times) parts.push_back(meeting_part(met, one, other));
    }
  join(parts);
  count_cuts_as_inside({parts_a, velocity_a}, {parts_b, velocity_b}, within, parts);
  return parts;
}

// Polygons of many bodies, asked together.
class PolygonPairs {
 public:
  using Pair = std::pair<std::uint32_t, std::uint32_t>;

  PolygonPairs(std::span<const MovingShape> bodies, std::span<const Pair> pairs, Range within)
      : bodies_(bodies), pairs_(pairs), within_(within) {
    parts_.resize(bodies.size());
    shapes_of_.resize(bodies.size());
    for (const Pair& pair : pairs) {
      begin_.push_back(asks_.size());
      if (!takes(pair)) continue;
      make_ready(pair.first);
      make_ready(pair.second);
      for (std::uint32_t p = 0; p < parts_[pair.first].size(); ++p)
        for (std::uint32_t q = 0; q < parts_[pair.second].size(); ++q)
          asks_.push_back({shapes_of_[pair.first] + p, shapes_of_[pair.second] + q,
                           bodies[pair.first].velocity, bodies[pair.second].velocity});
    }
    begin_.push_back(asks_.size());
  }

  // Whether all there is to two bodies are polygons that do not turn.
  bool takes(const Pair& pair) const {
    const auto plain = [](const MovingShape& body) {
      return body.spin == 0 && body.shape->circles.empty() && body.shape->arc_paths.empty();
    };
    return plain(bodies_[pair.first]) && plain(bodies_[pair.second]);
  }

  void ask(unsigned threads) {
    found_.resize(asks_.size());
    constexpr std::size_t kBlock = 2048;
    parallel_for((asks_.size() + kBlock - 1) / kBlock, threads, [&](std::size_t block) {
      const std::size_t from = block * kBlock, count = std::min(kBlock, asks_.size() - from);
      contacts(shapes_, std::span(asks_).subspan(from, count), within_,
               std::span(found_).subspan(from, count));
    });
  }

  std::vector<MeetingPart> meetings(std::size_t pair) const {
    std::vector<MeetingPart> parts;
    for (std::size_t i = begin_[pair]; i < begin_[pair + 1]; ++i) {
      if (!found_[i].times) continue;
      const MovingPair& ask = asks_[i];
      const RoundBody a{{shapes_.ring(ask.a), ask.velocity_a}},
          b{{shapes_.ring(ask.b), ask.velocity_b}};
      parts.push_back(meeting_part(round_contact(found_[i], a, b), a, b));
    }
    join(parts);
    const auto& [a, b] = pairs_[pair];
    count_cuts_as_inside({parts_[a], bodies_[a].velocity}, {parts_[b], bodies_[b].velocity},
                         within_, parts);
    return parts;
  }

 private:
  void make_ready(std::uint32_t body) {
    if (!parts_[body].empty()) return;
    parts_[body] = parts_of(*bodies_[body].shape, bodies_[body].place);
    shapes_of_[body] = static_cast<std::uint32_t>(shapes_.size());
    for (const ShapePart& part : parts_[body]) shapes_.add(part.ring);
  }

  const std::span<const MovingShape> bodies_;
  const std::span<const Pair> pairs_;
  const Range within_;
  std::vector<std::vector<ShapePart>> parts_;  // by body, as far as asked
  std::vector<std::uint32_t> shapes_of_;       // the first shape of each
  PolygonSet shapes_;
  std::vector<MovingPair> asks_;
  std::vector<std::size_t> begin_;  // of the asks of each pair
  std::vector<Contact> found_;
};

}  // namespace

std::vector<ShapePart> parts_of(const Shape& shape, const Pose& place) {
  std::vector<ShapePart> all;
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

std::vector<ShapePart> box_part(const MovingShape& moving) {
  const Bounds box = shape_bounds(*moving.shape, moving.place);
  if (box.empty()) return {};
  return {{{box.low, {box.high.x(), box.low.y()}, box.high, {box.low.x(), box.high.y()}}}};
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

std::vector<MeetingPart> shapes_meet(const MovingShape& a, const MovingShape& b, Range within) {
  if (a.spin != 0 || b.spin != 0) return turning_shapes_meet(a, b, within.high);
  return parts_meet(parts_of(*a.shape, a.place), a.velocity, parts_of(*b.shape, b.place),
                    b.velocity, within);
}

std::vector<std::vector<MeetingPart>> pairs_meet(
    std::span<const MovingShape> bodies,
    std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs, Range within,
    unsigned threads) {
  // Making shapes ready pays for those that are asked about more than once.
  std::vector<bool> asked(bodies.size());
  for (const auto& [a, b] : pairs) asked[a] = asked[b] = true;
  const auto shapes = std::count(asked.begin(), asked.end(), true);
  const bool together = pairs.size() > static_cast<std::size_t>(shapes);
  PolygonPairs polygons(bodies, together ? pairs : pairs.first(0), within);
  polygons.ask(threads);
  std::vector<std::vector<MeetingPart>> met(pairs.size());
  parallel_for(pairs.size(), threads, [&](std::size_t i) {
    const auto& [a, b] = pairs[i];
    met[i] = together && polygons.takes(pairs[i]) ? polygons.meetings(i)
                                                  : shapes_meet(bodies[a], bodies[b], within);
  });
  return met;
}

std::vector<MeetingPart> boxes_meet(const MovingShape& a, const MovingShape& b, Range within) {
  return parts_meet(box_part(a), a.velocity, box_part(b), b.velocity, within);
}

}  // namespace flatray
