#include "study/periodic/disc_words.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/portable_math.h"
#include "study/periodic/stationary.h"

namespace flatray {
namespace {

constexpr double kRough = 1e-12;  // far more than what bounds lose by rounding

Vec2 quarter_turned(const Vec2& v) { return {-v.y(), v.x()}; }
double angle_between(const Vec2& a, const Vec2& b) {
  return std::fabs(portable::atan2(cross(a, b), a.dot(b))) + kRough;
}
// A number from 0 to `high`.
Near from_0_to(double high) { return Near::within(high / 2, high / 2 * (1 + kRough)); }

// What a word says of every orbit that stays for ever and has it as a part: where its bounces are.
class WordOrbit {
 public:
  WordOrbit(const OpenDiscs& discs, const Word& word)
      : discs_(discs), word_(word), spots_(word.size()), slope_(word.size()) {
    for (std::size_t k = 0; k < word.size(); ++k) spots_[k].disc = discs[word[k]];
    place_ends();
    for (std::size_t k = 1; k + 1 < word.size(); ++k)
      spots_[k].at = discs.middle(word[k - 1], word[k], word[k + 1]);
    improve();
    for (std::size_t k = 1; k + 1 < word.size(); ++k)
      spots_[k].off = discs.play(word[k - 1], word[k], word[k + 1]) +
                      angle_between(spots_[k].at, discs.middle(word[k - 1], word[k], word[k + 1]));
    follow();
    constexpr int kPasses = 3;
    for (int i = 0; i < kPasses; ++i) tighten();
  }

  // From the bounce in its middle to the next: the length of the way, and how much wider what is across an
  // unstable orbit gets on it.
  OrbitStep middle_step() const {
    const std::size_t middle = (word_.size() - 1) / 2;
    Leg in = with_play(0);
    const auto any_front = [](const Leg& leg) { return from_0_to((Near(1) / leg.length).high()); };
    Near front = any_front(in);  // 1 / its radius, where it comes to a bounce
    for (std::size_t k = 1;; ++k) {
      const Leg out = with_play(k);
      const Near across = cosine(k, in, out);
      const bool known = across.low() > 0;
      const Near bend = front + Near(2) / (Near(spots_[k].disc.radius) * across);
      const Near stretch = known ? Near(1) + out.length * bend : Near::within(1, kInfinity);
      if (k == middle) return {out.length, stretch};
      front = known ? (Near(1) - Near(1) / stretch) / out.length : any_front(out);
      in = out;
    }
  }

 private:
  struct Spot {
    Circle disc;
    Vec2 at{1, 0};   // from the centre, near length 1
    double off = 0;  // radians on either side within which the bounce is
    Vec2 point() const { return disc.centre + disc.radius * at; }
  };
  // From a bounce to the next: cosines of the angles at which it leaves and arrives.
  struct Leg {
    Near length, out, into;
    double turn = 0;  // by how much play may turn it
  };

  // The disc beyond each end may be any other.
  void place_ends() {
    const auto place = [&](Spot& spot, std::size_t next, std::size_t at) {
      Vec2 sum(0, 0);
      for (std::size_t beyond = 0; beyond < discs_.size(); ++beyond)
        if (beyond != at) sum += discs_.middle(beyond, at, next);
      spot.at = direction_of(sum);
      for (std::size_t beyond = 0; beyond < discs_.size(); ++beyond)
        if (beyond != at)
          spot.off = std::max(spot.off, angle_between(spot.at, discs_.middle(beyond, at, next)) +
                                            discs_.play(beyond, at, next));
    };
    place(spots_.front(), word_[1], word_[0]);
    place(spots_.back(), word_[word_.size() - 2], word_.back());
  }

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

  // A leg with all that the play of its ends can make of it.
  Leg with_play(std::size_t k) const {
    const Spot &a = spots_[k], &b = spots_[k + 1];
    const Leg& leg = legs_[k];
    const double play_a = a.disc.radius * a.off, play_b = b.disc.radius * b.off;
    const double least = leg.length.low(), shift = play_a + play_b;
    const bool known = shift < least && leg.out.low() > 0 && leg.into.low() > 0;
    if (!known) return {Near::within(0, kInfinity), 0.0, 0.0, kInfinity};
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
  made.find_plays();
  return made;
}

Vec2 OpenDiscs::both_ways(std::size_t before, std::size_t at, std::size_t after) const {
  return direction_of(all_[before].centre - all_[at].centre) +
         direction_of(all_[after].centre - all_[at].centre);
}
Vec2 OpenDiscs::middle(std::size_t before, std::size_t at, std::size_t after) const {
  return direction_of(both_ways(before, at, after));
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

void OpenDiscs::find_plays() {
  constexpr int kRounds = 20;
  plays_.assign(size() * size() * size(), std::numbers::pi / 2);
  for (int round = 0; round < kRounds; ++round) {
    std::vector<double> next;
    for (std::size_t i = 0; i < size(); ++i)
      for (std::size_t j = 0; j < size(); ++j)
        for (std::size_t k = 0; k < size(); ++k)
          next.push_back(i == j || j == k ? 0 : std::min(play(i, j, k), narrowed_play(i, j, k)));
    plays_ = std::move(next);
  }
}

// A bounce halves the angle between the ways to the bounces before and after it.
double OpenDiscs::narrowed_play(std::size_t i, std::size_t j, std::size_t k) const {
  const Range to = turned_ways(i, j, k, i), from = turned_ways(i, j, k, k);
  return std::max(-to.low - from.low, to.high + from.high) / 2 + kRough;
}

// How ways to a disc are turned from the way between centres, wherever the bounces are.
Range OpenDiscs::turned_ways(std::size_t i, std::size_t j, std::size_t k, std::size_t to) const {
  const Vec2 straight = all_[to].centre - all_[j].centre;
  const double most = portable::asin(
      std::min(1.0, (all_[to].radius + all_[j].radius) / std::sqrt(straight.squaredNorm())));
  Range range{kInfinity, -kInfinity};
  for (std::size_t beyond = 0; beyond < size(); ++beyond) {
    if (beyond == to) continue;
    const Vec2 way =
        straight + all_[to].radius * middle(beyond, to, j) - all_[j].radius * middle(i, j, k);
    const double shift = all_[to].radius * play(beyond, to, j) + all_[j].radius * play(i, j, k),
                 length = std::sqrt(way.squaredNorm());
    const double about = portable::atan2(cross(straight, way), straight.dot(way)),
                 turn = shift < length ? portable::asin(shift / length) : std::numbers::pi;
    range = {std::min(range.low, about - turn), std::max(range.high, about + turn)};
  }
  return {std::max(range.low, -most) - kRough, std::min(range.high, most) + kRough};
}

OrbitStep middle_step(const OpenDiscs& discs, const Word& word) {
  return WordOrbit(discs, word).middle_step();
}

}  // namespace flatray
