#include "study/periodic/open_discs.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "study/periodic/stationary.h"

namespace flatray {
namespace {

constexpr double kRight = std::numbers::pi / 2;

Vec2 turned(const Vec2& v, double by) {
  return portable::cos(by) * v + portable::sin(by) * Vec2(-v.y(), v.x());
}

// How ways to a bounce are turned from the way to the centre of its disc, seen from `back` of that
// centre.
Range turns_to(const Vec2& back, const BounceArc& bounce) {
  const double far = std::sqrt(back.squaredNorm()), radius = bounce.disc.radius;
  const auto turn = [&](double beta) {
    return portable::atan2(-radius * portable::sin(beta), far - radius * portable::cos(beta));
  };
  const double about = turn_between(back, bounce.at);
  const double low = about - bounce.off, high = about + bounce.off;
  const double edge = portable::asin(radius / far), seen = kRight - edge;  // it is widest there
  Range turns{std::min(turn(low), turn(high)), std::max(turn(low), turn(high))};
  if (low < seen && seen < high) turns.low = -edge;
  if (low < -seen && -seen < high) turns.high = edge;
  return turns;
}

// How ways to some bounces are turned from the normal of a disc at `at`, from within `half` radians
// of there; empty where none leaves the disc.
Range ways(const Circle& disc, const Vec2& at, double half, std::span<const BounceArc> bounces) {
  Range all{kInfinity, -kInfinity};
  const double most = kRight + half + kRough;
  for (const BounceArc& to : bounces) {
    const Vec2 back = disc.centre - to.disc.centre + disc.radius * at;
    const double far = std::sqrt(back.squaredNorm()), least = far - to.disc.radius;
    const double shift =
        disc.radius * half + kRough * (far + disc.radius + to.disc.radius);  // rounding, too
    if (!(shift < least)) return {-most, most};
    const Range turns = turns_to(back, to);
    const double straight = turn_between(at, -back), play = portable::asin(shift / least) + kRough;
    for (const double around : {-4 * kRight, 0.0, 4 * kRight}) {
      const Range one{std::max(straight + turns.low - play + around, -most),
                      std::min(straight + turns.high + play + around, most)};
      if (one.low <= one.high) all = {std::min(all.low, one.low), std::max(all.high, one.high)};
    }
  }
  return all;
}

// Whether a bounce may be within `half` radians of `at` on a disc: the normal there halves the
// angle between the ways to the bounces before and after it.
bool may_bounce(const Circle& disc, const Vec2& at, double half, std::span<const BounceArc> before,
                std::span<const BounceArc> after) {
  const Range in = ways(disc, at, half, before), out = ways(disc, at, half, after);
  const double most = 2 * (half + kRough);
  return in.low <= in.high && out.low <= out.high && in.low + out.low <= most &&
         in.high + out.high >= -most;
}

// Takes off the ends of an arc what no bounce is on. Gives   whether it took any.
bool narrow(BounceArc& arc, std::span<const BounceArc> before, std::span<const BounceArc> after) {
  constexpr double kSlices = 16, kLeast = 1e-3;
  bool any = false;
  for (const double side : {-1.0, 1.0})
    while (arc.off > kLeast) {
      const double half = arc.off / kSlices;
      if (may_bounce(arc.disc, turned(arc.at, side * (arc.off - half)), half, before, after)) break;
      arc.at = direction_of(turned(arc.at, -side * half));
      arc.off -= half * (1 - 1e-9);
      any = true;
    }
  return any;
}

// The least arc that holds arcs of one disc.
BounceArc hull(std::span<const BounceArc> arcs) {
  const BounceArc& first = arcs.front();
  Range all{-first.off, first.off};
  for (const BounceArc& one : arcs.subspan(1)) {
    const double about = turn_between(first.at, one.at);
    all = {std::min(all.low, about - one.off), std::max(all.high, about + one.off)};
  }
  return {first.disc, direction_of(turned(first.at, (all.low + all.high) / 2)),
          (all.high - all.low) / 2 + kRough};
}

}  // namespace

tl::expected<OpenDiscs, std::string> OpenDiscs::of(const MirrorRoom& room) {
  OpenDiscs made;
  for (const Mirror& one : room.mirrors) {
    if (!one.is_disc() || one.arc->extent != Arc::Extent::whole)
      return tl::unexpected(std::string("a wall is no whole disc"));
    made.all_.push_back(circle_of(one.arc->curve));
  }
  for (std::size_t i = 0; i < made.size(); ++i)
    for (std::size_t j = 0; j < made.size(); ++j)
      for (std::size_t k = 0; k < made.size(); ++k)
        if (i != k && j != k && !(made.is_apart(i, j, k) && made.middle_is_known(i, k, j)))
          return tl::unexpected(
              std::string("a disc is near another or near the way between two others"));
  for (std::uint32_t i = 0; i < room.room.walls().size(); ++i)
    if (room.room.materials()[i] != Material::mirror && !made.are_beside(room.room.walls(), i))
      return tl::unexpected(std::string("a wall that is no mirror may stand between discs"));
  made.find_arcs();
  return made;
}

Vec2 OpenDiscs::both_ways(std::size_t before, std::size_t at, std::size_t after) const {
  return direction_of(all_[before].centre - all_[at].centre) +
         direction_of(all_[after].centre - all_[at].centre);
}
// To kRough, as far as rounding goes.
bool OpenDiscs::middle_is_known(std::size_t before, std::size_t at, std::size_t after) const {
  return both_ways(before, at, after).squaredNorm() > 1e-4;
}

// Whether k is apart from all that lies between i and j, or from i alone.
bool OpenDiscs::is_apart(std::size_t i, std::size_t j, std::size_t k) const {
  const Pair<Near> a = near(all_[i].centre), to = near(all_[k].centre) - a,
                   way = near(all_[j].centre) - a;
  // More by far than what is neglected where it is in doubt whether the way passes the disc.
  const Near reach =
      Near(1 + kRough) * (Near(std::max(all_[i].radius, all_[j].radius)) + all_[k].radius);
  const Near size = dot(way, way), foot = dot(to, way), off = cross(to, way);
  if (is_positive(foot) == Proof::yes && is_positive(size - foot) == Proof::yes)
    return is_positive(off * off - reach * reach * size) == Proof::yes;
  const Pair<Near> back = to - way;
  return is_positive(dot(to, to) - reach * reach) == Proof::yes &&
         (is_positive(-foot) == Proof::yes ||
          is_positive(dot(back, back) - reach * reach) == Proof::yes);
}

// Whether all lie on one side of a straight wall, so that none of their ways meets it.
bool OpenDiscs::are_beside(const Surfaces& walls, std::uint32_t surface) const {
  if (walls.segment_slot(surface) == kNoSurface) return false;
  const Segment& wall = walls.segment(surface);
  const Pair<Near> from = near(wall.a), along = near(wall.b) - from;
  Proof left = Proof::yes, right = Proof::yes;
  for (const Circle& disc : all_) {
    const Near off = cross(along, near(disc.centre) - from), reach = disc.radius * length_of(along);
    left = left & is_positive(off - reach);
    right = right & is_positive(-off - reach);
  }
  return left == Proof::yes || right == Proof::yes;
}

// With one bounce before and after from the half of a disc that faces both, with more from what
// those with fewer have come to; in the end with fewer again, from all that may stand there.
void OpenDiscs::find_arcs() {
  constexpr std::size_t kMostArcs = 1000;
  Arcs all{NumberedWords(size(), 3), 1};
  for (std::size_t i = 0; i < all.words.size(); ++i) {
    const Word word = all.words[i];
    all.arcs.push_back({all_[word[1]], direction_of(both_ways(word[0], word[1], word[2])), kRight});
  }
  narrow_together(all);
  while (size() > 2 && 2 * all.before + 3 <= NumberedWords::most_bounces(size(), kMostArcs)) {
    Arcs more{NumberedWords(size(), 2 * all.before + 3), all.before + 1};
    for (std::size_t i = 0; i < more.words.size(); ++i) {
      const Word word = more.words[i];
      more.arcs.push_back(all.arcs[all.words.number_of(std::span(word).subspan(1))]);
    }
    narrow_together(more);
    all = std::move(more);
  }
  most_ = all.before;
  arcs_.assign((most_ + 1) * (most_ + 1), all);
  for (std::size_t before = most_ + 1; before-- > 0;)
    for (std::size_t after = most_ + 1; after-- > 0;)
      if (before + after > 0 && before + after < 2 * most_)
        arcs_[before * (most_ + 1) + after] =
            before < most_ ? with_fewer(arcs_[(before + 1) * (most_ + 1) + after], true)
                           : with_fewer(arcs_[before * (most_ + 1) + after + 1], false);
}

// Arcs of words without their first or last bounce.
OpenDiscs::Arcs OpenDiscs::with_fewer(const Arcs& known, bool at_front) const {
  Arcs fewer{NumberedWords(size(), known.words.bounces() - 1), known.before - (at_front ? 1 : 0)};
  for (std::size_t i = 0; i < fewer.words.size(); ++i) {
    Word word = fewer.words[i];
    const auto beyond = word.insert(at_front ? word.begin() : word.end(), 0);
    const std::uint8_t next = at_front ? word[1] : word[word.size() - 2];
    std::vector<BounceArc> all;
    for (std::size_t disc = 0; disc < size(); ++disc) {
      *beyond = static_cast<std::uint8_t>(disc);
      if (disc != next) all.push_back(known.arcs[known.words.number_of(word)]);
    }
    fewer.arcs.push_back(hull(all));
  }
  return fewer;
}

// Until none gives way: what comes before and after the middle bounce of a word is the middle one
// of words that overlap it.
void OpenDiscs::narrow_together(Arcs& level) const {
  constexpr int kMostRounds = 400;
  const std::size_t n = level.words.bounces();
  bool any = true;
  for (int round = 0; round < kMostRounds && std::exchange(any, false); ++round)
    for (std::size_t i = 0; i < level.words.size(); ++i) {
      Word word = level.words[i];
      word.insert(word.begin(), 0);
      word.push_back(0);
      std::vector<BounceArc> before, after;
      for (std::size_t beyond = 0; beyond < size(); ++beyond) {
        word.front() = word.back() = static_cast<std::uint8_t>(beyond);
        const std::span<const std::uint8_t> all(word);
        if (beyond != word[1]) before.push_back(level.arcs[level.words.number_of(all.first(n))]);
        if (beyond != word[n]) after.push_back(level.arcs[level.words.number_of(all.last(n))]);
      }
      any = narrow(level.arcs[i], before, after) || any;
    }
}

const BounceArc& OpenDiscs::arc(const Word& word, std::size_t at) const {
  const std::size_t before = std::min(at, most_), after = std::min(word.size() - 1 - at, most_);
  const Arcs& of = arcs_[before * (most_ + 1) + after];
  return of.arcs[of.words.number_of(std::span(word).subspan(at - before))];
}

}  // namespace flatray
