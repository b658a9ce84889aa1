#include "study/periodic/disc_words.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "base/portable_math.h"
#include "study/periodic/stationary.h"

namespace flatray {
namespace {

constexpr double kRough = 1e-12;  // far more than what bounds lose by rounding
constexpr double kRight = std::numbers::pi / 2;

Vec2 quarter_turned(const Vec2& v) { return {-v.y(), v.x()}; }
double angle_between(const Vec2& a, const Vec2& b) {
  return std::fabs(portable::atan2(cross(a, b), a.dot(b))) + kRough;
}
Vec2 turned(const Vec2& v, double by) {
  return portable::cos(by) * v + portable::sin(by) * quarter_turned(v);
}
double signed_angle(const Vec2& from, const Vec2& to) {
  return portable::atan2(cross(from, to), from.dot(to));
}

// How ways to a bounce are turned from the way to the centre of its disc, seen from `back` of that centre.
Range turns_to(const Vec2& back, const BounceArc& bounce) {
  const double far = std::sqrt(back.squaredNorm()), radius = bounce.disc.radius;
  const auto turn = [&](double beta) {
    return portable::atan2(-radius * portable::sin(beta), far - radius * portable::cos(beta));
  };
  const double about = signed_angle(back, bounce.at);
  const double low = about - bounce.off, high = about + bounce.off;
  const double edge = portable::asin(radius / far), seen = kRight - edge;  // it is widest there
  Range turns{std::min(turn(low), turn(high)), std::max(turn(low), turn(high))};
  if (low < seen && seen < high) turns.low = -edge;
  if (low < -seen && -seen < high) turns.high = edge;
  return turns;
}

// How ways to some bounces are turned from the normal of a disc at `at`, from within `half` radians of there; empty
// where none leaves the disc.
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
    const double straight = signed_angle(at, -back), play = portable::asin(shift / least) + kRough;
    for (const double around : {-4 * kRight, 0.0, 4 * kRight}) {
      const Range one{std::max(straight + turns.low - play + around, -most),
                      std::min(straight + turns.high + play + around, most)};
      if (one.low <= one.high) all = {std::min(all.low, one.low), std::max(all.high, one.high)};
    }
  }
  return all;
}

// Whether a bounce may be within `half` radians of `at` on a disc: the normal there halves the angle between the ways to
// the bounces before and after it.
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
    const double about = signed_angle(first.at, one.at);
    all = {std::min(all.low, about - one.off), std::max(all.high, about + one.off)};
  }
  return {first.disc, direction_of(turned(first.at, (all.low + all.high) / 2)),
          (all.high - all.low) / 2 + kRough};
}

// A number from 0 to `high`.
Near from_0_to(double high) { return Near::within(high / 2, high / 2 * (1 + kRough)); }
const Near kAnything = Near::within(0, kInfinity);
// What of an enclosure is between bounds that are known of the number, too.
Near cut(const Near& number, const Range& bounds) {
  const double low = std::max(bounds.low, number.low()),
               high = std::min(bounds.high, number.high());
  if (bounds.low < number.low() && number.high() < bounds.high) return number;
  if (!(high < kInfinity)) return Near::within(low, kInfinity);
  return Near(low) + from_0_to((high - low) * (1 + kRough));
}

// What a word says of every orbit that stays for ever and has it as a part: where its bounces are.
class WordOrbit {
 public:
  WordOrbit(const OpenDiscs& discs, const Word& word)
      : discs_(discs), word_(word), spots_(word.size()), slope_(word.size()) {
    for (std::size_t k = 0; k < word.size(); ++k) spots_[k] = {discs.arc(word, k)};
    const std::vector<Spot> arcs = spots_;
    improve();
    for (std::size_t k = 1; k + 1 < word.size(); ++k)
      spots_[k].off += angle_between(spots_[k].at, arcs[k].at);
    follow();
    constexpr int kPasses = 3;
    for (int i = 0; i < kPasses; ++i) tighten();
  }

  // From the bounce in its middle to the next: the length of the way, and how much wider what is across an
  // unstable orbit gets on it.
  OrbitStep middle_step() const {
    const std::size_t middle = (word_.size() - 1) / 2;
    Leg in = with_play(0);
    Near front = front_after(in, kAnything);  // 1 / its radius, where it comes to a bounce
    for (std::size_t k = 1;; ++k) {
      const Leg out = with_play(k);
      const Near radius(spots_[k].disc.radius), across = cosine(k, in, out);
      const Near bend = across.low() > 0 ? front + Near(2) / (radius * across) : kAnything;
      const double least = (Near(1) + Near(2) * out.length / radius).low();
      const Near stretch = cut(Near(1) + out.length * bend, {least, kInfinity});
      if (k == middle) return {out.length, stretch};
      front = front_after(out, stretch);
      in = out;
    }
  }

 private:
  struct Spot : BounceArc {
    Vec2 point() const { return disc.centre + disc.radius * at; }
  };
  // From a bounce to the next: cosines of the angles at which it leaves and arrives.
  struct Leg {
    Near length, out, into;
    double turn = 0;  // by how much play may turn it
  };

  // Newton's method in plain doubles to where the length is stationary.
  void improve() {
    constexpr int kRounds = 5;
    const std::size_t n = spots_.size();
    std::vector<double> slope(n, 0), own(n, 0), shared(n, 0);
    for (int round = 0; round < kRounds; ++round) {
      std::fill(slope.begin(), slope.end(), 0);
      std::fill(own.begin(), own.end(), 0);
      for (std::size_t k = 0; k + 1 < n; ++k) {
        const Spot &a = spots_[k], &b = spots_[k + 1];
        const Vec2 w = b.point() - a.point();
        const double length = std::sqrt(w.squaredNorm());
        const Vec2 way = w / length;
        const double out = a.disc.radius * a.at.dot(way), into = -b.disc.radius * b.at.dot(way);
        slope[k] -= a.disc.radius * quarter_turned(a.at).dot(way);
        slope[k + 1] += b.disc.radius * quarter_turned(b.at).dot(way);
        own[k] += out * out / length + out;
        own[k + 1] += into * into / length + into;
        shared[k] = -out * into / length;  // directions turn the other way on a disc opposite
      }
      solve(own, shared, slope);
      for (std::size_t k = 1; k + 1 < n; ++k)
        spots_[k].at = direction_of(spots_[k].at - slope[k] * quarter_turned(spots_[k].at));
    }
  }

  // Solves own[k] x[k] - shared[k - 1] x[k - 1] - shared[k] x[k + 1] = x[k] as given, between ends that are 0.
  static void solve(std::vector<double> own, const std::vector<double>& shared,
                    std::vector<double>& x) {
    const std::size_t last = x.size() - 1;
    for (std::size_t k = 2; k < last; ++k) {
      const double share = shared[k - 1] / own[k - 1];
      own[k] -= share * shared[k - 1];
      x[k] += share * x[k - 1];
    }
    x[0] = x[last] = 0;
    for (std::size_t k = last - 1; k > 0; --k) x[k] = (x[k] + shared[k] * x[k + 1]) / own[k];
  }

  // The legs where the bounces are taken to be, and what slope their length has there.
  void follow() {
    const auto direction = [](const Spot& spot) {
      const Pair<Near> about = near(spot.at);
      const Near size = length_of(about);
      return Pair<Near>{about.x / size, about.y / size};
    };
    Pair<Near> from = direction(spots_[0]);
    std::vector<Near> slopes(spots_.size(), 0);
    for (std::size_t k = 0; k + 1 < spots_.size(); ++k) {
      const Circle &a = spots_[k].disc, &b = spots_[k + 1].disc;
      const Near radius(a.radius), radius_after(b.radius);
      const Pair<Near> to = direction(spots_[k + 1]);
      const Pair<Near> w = near(b.centre) - near(a.centre) + radius_after * to - radius * from;
      const Near length = length_of(w);
      const Pair<Near> way{w.x / length, w.y / length};
      legs_.push_back({length, dot(from, way), -dot(to, way)});
      slopes[k] = slopes[k] - radius * cross(from, way);
      slopes[k + 1] = slopes[k + 1] + radius_after * cross(to, way);
      from = to;
    }
    for (std::size_t k = 0; k < slopes.size(); ++k)
      slope_[k] = (1 + kRough) * std::max(slopes[k].high(), -slopes[k].low());
  }

  // The cosine of an angle that may be turned: cos(a + t) is cos a cos t - sin a sin t.
  static Near turned(const Near& cosine, double by) {
    return cosine + Near::within(0, (sine_of(cosine) * by + by * by / 2) * (1 + kRough));
  }
  static double sine_of(const Near& cosine) {
    return std::sqrt(std::max(0.0, 1 - cosine.low() * cosine.low()) + 0x1p-50);
  }

  static Near front_after(const Leg& leg, const Near& stretch) {
    return cut((Near(1) - Near(1) / stretch) / leg.length, {0, (Near(1) / leg.length).high()});
  }

  // Between any points of two discs that see each other.
  static Leg any_leg(const Circle& a, const Circle& b) {
    const Near apart = length_of(near(b.centre) - near(a.centre)),
               radii = Near(a.radius) + b.radius;
    const Near share = from_0_to(1);
    return {apart, share, share, kInfinity};
  }

  // A leg with all that the play of its ends can make of it.
  Leg with_play(std::size_t k) const {
    const Spot &a = spots_[k], &b = spots_[k + 1];
    const Leg& leg = legs_[k];
    const double play_a = a.disc.radius * a.off, play_b = b.disc.radius * b.off;
    const double least = leg.length.low(), shift = play_a + play_b;
    const bool known = shift < least && leg.out.low() > 0 && leg.into.low() > 0;
    if (!known) return any_leg(a.disc, b.disc);
    const double turn = shift / std::sqrt(least * least - shift * shift);
    const double by_a = a.off + turn, by_b = b.off + turn;
    const double longer = std::min(1.0, sine_of(leg.out) + by_a) * play_a +
                          std::min(1.0, sine_of(leg.into) + by_b) * play_b;
    Leg all{leg.length + Near::within(0, longer * (1 + kRough)), turned(leg.out, by_a),
            turned(leg.into, by_b)};
    const double across = all.out.high() * play_a + all.into.high() * play_b;
    all.turn = turn * (1 + kRough);
    if (all.length.low() > 0) all.turn = std::min(turn, across / all.length.low()) * (1 + kRough);
    return all;
  }

  // The cosine of the angle at a bounce, which is half of that between the ways to and from it; where the bounce is
  // taken to be these make angles that differ by its slope.
  Near cosine(std::size_t k, const Leg& in, const Leg& out) const {
    const Near& into = legs_[k - 1].into;
    return turned(into,
                  (in.turn + out.turn) / 2 + slope_[k] / (spots_[k].disc.radius * into.low()));
  }

  // The slope at each bounce, 0 of an orbit, is what it is where the bounces are taken to be, and second derivatives
  // between there and the orbit times what is off: so much of one is off at most, where so much of its neighbours is.
  void tighten() {
    const std::size_t n = spots_.size();
    std::vector<double> own(n, 0), shared(n, 0);
    Leg in = with_play(0);
    for (std::size_t k = 0; k + 1 < n; ++k) {
      const Leg out = with_play(k);
      const Near radius(spots_[k].disc.radius), beyond(spots_[k + 1].disc.radius);
      shared[k] = (radius * beyond * out.out * out.into / out.length).high();
      const bool surely = in.into.low() > 0 && out.out.low() > 0 && out.into.low() > 0;
      const Near curved = in.into * in.into / in.length + out.out * out.out / out.length;
      own[k] = surely ? (radius * (radius * curved + in.into + out.out)).low() : 0;
      in = out;
    }
    constexpr int kSweeps = 4;
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      for (std::size_t k = 1; k + 1 < n; ++k) tighten(k, own, shared);
      for (std::size_t k = n - 2; k > 0; --k) tighten(k, own, shared);
    }
  }
  void tighten(std::size_t k, const std::vector<double>& own, const std::vector<double>& shared) {
    if (!(own[k] > 0)) return;
    const double rest =
        slope_[k] + shared[k - 1] * spots_[k - 1].off + shared[k] * spots_[k + 1].off;
    spots_[k].off = std::min(spots_[k].off, rest / own[k] * (1 + kRough));
  }

  const OpenDiscs& discs_;
  const Word& word_;
  std::vector<Spot> spots_;
  std::vector<Leg> legs_;
  std::vector<double> slope_;  // of the length, by bounce, at most
};

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
  const Segment wall = walls.segment(surface);
  const Pair<Near> from = near(wall.a), along = near(wall.b) - from;
  Proof left = Proof::yes, right = Proof::yes;
  for (const Circle& disc : all_) {
    const Near off = cross(along, near(disc.centre) - from), reach = disc.radius * length_of(along);
    left = left & is_positive(off - reach);
    right = right & is_positive(-off - reach);
  }
  return left == Proof::yes || right == Proof::yes;
}

// With one bounce before and after from the half of a disc that faces both, with more from what those with fewer have
// come to; in the end with fewer again, from all that may stand there.
void OpenDiscs::find_arcs() {
  constexpr std::size_t kMostArcs = 1000;
  Arcs all{NumberedWords(size(), 3), 1};
  for (std::size_t i = 0; i < all.words.size(); ++i) {
    const Word word = all.words[i];
    all.arcs.push_back(
        {all_[word[1]], direction_of(both_ways(word[0], word[1], word[2])), std::numbers::pi / 2});
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
    for (std::uint8_t disc = 0; disc < size(); ++disc) {
      *beyond = disc;
      if (disc != next) all.push_back(known.arcs[known.words.number_of(word)]);
    }
    fewer.arcs.push_back(hull(all));
  }
  return fewer;
}

// Until none gives way: what comes before and after the middle bounce of a word is the middle one of words that overlap it.
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

OrbitStep middle_step(const OpenDiscs& discs, const Word& word) {
  return WordOrbit(discs, word).middle_step();
}

}  // namespace flatray
