#include "collide/outline_contact.h"

#include <algorithm>

#include "anim/world.h"
#include "base/parallel.h"
#include "collide/contact_batch.h"
#include "collide/curved_contact.h"
#include "collide/inner_cuts.h"
#include "scene/rounded.h"

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

// Meetings of all parts of two bodies; `contact_of(p, q)`: of two that are no ellipses, by number.
template <class ContactOf>
std::vector<MeetingPart> parts_meet(const MovingParts& a, const MovingParts& b, Range within,
                                    const ContactOf& contact_of) {
  std::vector<MeetingPart> met;
  for (std::size_t i = 0; i < a.parts.size(); ++i)
    for (std::size_t k = 0; k < b.parts.size(); ++k) {
      const ShapePart &p = a.parts[i], &q = b.parts[k];
      if (p.curve || q.curve) {
        if (const auto part = curved_parts_meet(p, a.velocity, q, b.velocity, within))
          met.push_back(*part);
        continue;
      }
      const Contact contact = contact_of(i, k);
      if (contact.times) met.push_back(meeting_part(contact, a.body(i), b.body(k)));
    }
  join(met);
  count_cuts_as_inside(a, b, within, met);
  return met;
}
std::vector<MeetingPart> parts_meet(const MovingParts& a, const MovingParts& b, Range within) {
  return parts_meet(a, b, within, [&](std::size_t i, std::size_t k) {
    return contact(a.body(i), b.body(k), within);
  });
}

// Parts of many bodies, made ready once and asked together.
class ReadyBodies {
 public:
  explicit ReadyBodies(std::span<const MovingShape> bodies)
      : bodies_(bodies), parts_(bodies.size()), first_(bodies.size()) {}

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
    return parts_meet(
        {parts_[a], bodies_[a].velocity}, {parts_[b], bodies_[b].velocity}, within,
        [&](std::size_t p, std::size_t q) { return found_[begin_[k] + p * parts_[b].size() + q]; });
  }

 private:
  void make_ready(std::uint32_t body) {
    if (!parts_[body].empty()) return;
    parts_[body] = parts_of(*bodies_[body].shape, bodies_[body].place);
    first_[body] = static_cast<std::uint32_t>(set_.size());
    for (const ShapePart& part : parts_[body]) set_.add(core_of(part), part.radius);
  }
  // Of an ellipse its centre: it is asked something else.
  static std::span<const Vec2> core_of(const ShapePart& part) {
    return part.curve ? std::span(&part.curve->centre, 1) : std::span(part.ring);
  }

  const std::span<const MovingShape> bodies_;
  std::vector<std::vector<ShapePart>> parts_;  // by body, as far as asked
  std::vector<std::uint32_t> first_;           // the number of the first part of each
  BodySet set_;
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

std::vector<MeetingPart> shapes_meet(const MovingShape& a, const MovingShape& b, Range within) {
  const std::vector<ShapePart> one = parts_of(*a.shape, a.place),
                               other = parts_of(*b.shape, b.place);
  return parts_meet({one, a.velocity}, {other, b.velocity}, within);
}

std::vector<std::vector<MeetingPart>> pairs_meet(
    std::span<const MovingShape> bodies,
    std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs, Range within,
    unsigned threads) {
  ReadyBodies ready(bodies);
  for (const auto& [a, b] : pairs) ready.add(a, b);
  ready.ask(within, threads);
  std::vector<std::vector<MeetingPart>> met(pairs.size());
  parallel_for(pairs.size(), threads, [&](std::size_t i) {
    met[i] = ready.meetings(i, pairs[i].first, pairs[i].second, within);
  });
  return met;
}

std::vector<MeetingPart> boxes_meet(const MovingShape& a, const MovingShape& b, Range within) {
  const std::vector<ShapePart> one = box_part(a), other = box_part(b);
  return parts_meet({one, a.velocity}, {other, b.velocity}, within);
}

}  // namespace flatray
