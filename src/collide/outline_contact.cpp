#include "collide/outline_contact.h"

#include <algorithm>
#include <array>

#include "anim/world.h"
#include "base/parallel.h"
#include "collide/contact_batch.h"
#include "collide/near_parts.h"
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
  if (std::ranges::all_of(pieces.parts, [](const ShapePart& part) { return part.cuts.empty(); }))
    return;
  std::vector<MovingBody> thin;
  for (const ShapePart& part : others.parts)
    if (!has_area(part)) thin.push_back(others.body(part));
  for (const auto& [ring, radius, curve, cuts] : pieces.parts)
    for (const std::uint32_t k : cuts)
      for (const MovingBody& body : thin)
        count_cut({ring[k], ring[(k + 1) % ring.size()]}, pieces.velocity, body, within, met);
}

std::vector<Contact> ask(const BodySet& bodies, std::span<const MovingPair> pairs, Range within,
                         unsigned threads) {
  std::vector<Contact> found(pairs.size());
  constexpr std::size_t kAtOnce = 2048;
  parallel_for((pairs.size() + kAtOnce - 1) / kAtOnce, threads, [&](std::size_t block) {
    const std::size_t from = block * kAtOnce, count = std::min(kAtOnce, pairs.size() - from);
    contacts(bodies, pairs.subspan(from, count), within, std::span(found).subspan(from, count));
  });
  return found;
}

// What parts of many pairs of bodies do, asked some at a time: of parts that stay apart nothing is kept.
class PairsMeet {
 public:
  using Parts = std::vector<MeetingPart>;

  PairsMeet(std::span<const MovingShape> bodies, std::span<const IndexPair> pairs, Range within,
            unsigned threads, Outline outline)
      : bodies_(bodies),
        pairs_(pairs),
        within_(within),
        threads_(threads),
        outline_(outline),
        parts_(bodies.size()),
        near_(bodies.size()),
        first_(bodies.size()),
        met_(pairs.size()) {}

  std::vector<Parts> run() && {
    for (const auto& [a, b] : pairs_) {
      make_ready(a);
      make_ready(b);
      begin_.push_back(asks_.size());
      const Vec2 &velocity_a = bodies_[a].velocity, &velocity_b = bodies_[b].velocity;
      for (std::uint32_t p = 0; p < parts_[a].size(); ++p)
        for (const std::size_t q : near_[b]->near(parts_[a][p], velocity_a - velocity_b, within_)) {
          if (asks_.size() == kMostAsks) answer(false);
          asks_.push_back(
              {first_[a] + p, first_[b] + static_cast<std::uint32_t>(q), velocity_a, velocity_b});
        }
    }
    answer(true);
    return std::move(met_);
  }

 private:
  static constexpr std::size_t kMostAsks = 1 << 16, kMostApart = 1 << 18;

  void make_ready(std::uint32_t body) {
    if (near_[body]) return;
    parts_[body] = parts_of(*bodies_[body].shape, bodies_[body].place, outline_);
    near_[body].emplace(parts_[body]);
    first_[body] = static_cast<std::uint32_t>(set_.size());
    for (const auto& [ring, radius, curve, cuts] :
         parts_[body])  // of an ellipse, asked apart, its centre
      set_.add(curve ? std::span(&curve->centre, 1) : std::span(ring), radius);
  }

  // All that is asked, and with that all pairs but the last, to which more may come.
  void answer(bool last_too) {
    const std::vector<Contact> found = ask(set_, asks_, within_, threads_);
    const std::size_t going_on = last_too ? begin_.size() : begin_.size() - 1;
    begin_.push_back(asks_.size());
    parallel_for(begin_.size() - 1, threads_, [&](std::size_t k) {
      const std::size_t pair = first_pair_ + k;
      for (std::size_t i = begin_[k]; i < begin_[k + 1]; ++i) add(pair, asks_[i], found[i]);
      if (k < going_on) finish(pair);
    });
    if (last_too) return;
    if (going_on > 0) joined_ = 0;
    first_pair_ += going_on;
    begin_ = {0};
    asks_.clear();
    join_early(met_[first_pair_]);
  }

  void add(std::size_t pair, const MovingPair& asked, const Contact& found) {
    const auto [a, b] = pairs_[pair];
    const ShapePart &p = parts_[a][asked.a - first_[a]], &q = parts_[b][asked.b - first_[b]];
    if (p.curve || q.curve) {
      if (const auto part = curved_parts_meet(p, asked.velocity_a, q, asked.velocity_b, within_))
        met_[pair].push_back(*part);
    } else if (found.times) {
      met_[pair].push_back(meeting_part(found, set_.body(asked.a, asked.velocity_a),
                                        set_.body(asked.b, asked.velocity_b)));
    }
  }

  // What is certain is joined in any parts, as long as their order stays.
  void join_early(Parts& met) {
    if (met.size() < 2 * joined_ + kMostApart || !std::ranges::all_of(met, &MeetingPart::certain))
      return;
    join(met);
    joined_ = met.size();
  }

  void finish(std::size_t pair) {
    const auto [a, b] = pairs_[pair];
    Parts& met = met_[pair];
    join(met);
    if (met.empty()) return;
    const MovingParts of_a{parts_[a], bodies_[a].velocity}, of_b{parts_[b], bodies_[b].velocity};
    count_cuts(of_a, of_b, within_, met);
    count_cuts(of_b, of_a, within_, met);
  }

  const std::span<const MovingShape> bodies_;
  const std::span<const IndexPair> pairs_;
  const Range within_;
  const unsigned threads_;
  const Outline outline_;
  std::vector<std::vector<ShapePart>> parts_;  // of bodies that are asked about
  std::vector<std::optional<NearParts>> near_;
  std::vector<std::uint32_t> first_;  // number of the first of them in the set
  BodySet set_;
  std::vector<MovingPair> asks_;    // of pairs from `first_pair_` on
  std::vector<std::size_t> begin_;  // of each of them
  std::size_t first_pair_ = 0, joined_ = 0;
  std::vector<Parts> met_;
};

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
  // Of equal ones the first stays first, whatever was joined before.
  std::ranges::stable_sort(parts, {}, [](const MeetingPart& part) { return part.times.low; });
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
  return PairsMeet(bodies, pairs, within, threads, outline).run();
}

}  // namespace flatray
