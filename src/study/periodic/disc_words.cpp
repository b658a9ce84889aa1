#include "study/periodic/disc_words.h"

#include <algorithm>
#include <cmath>

#include "study/periodic/stationary.h"

namespace flatray {
namespace {

Vec2 quarter_turned(const Vec2& v) { return {-v.y(), v.x()}; }
double angle_between(const Vec2& a, const Vec2& b) {
  return std::fabs(turn_between(a, b)) + kRough;
}
// A number from 0 to `high`.
Near from_0_to(double high) { return Near::within(high / 2, high / 2 * (1 + kRough)); }
Near anything() { return Near::within(0, kInfinity); }
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

  // From the bounce in its middle to the next: the length of the way, and how much wider what is
  // across an unstable orbit gets on it.
  OrbitStep middle_step() const {
    const std::size_t middle = (word_.size() - 1) / 2;
    Leg in = with_play(0);
    Near front = front_after(in, anything());  // 1 / its radius, where it comes to a bounce
    for (std::size_t k = 1;; ++k) {
      const Leg out = with_play(k);
      const Near radius(spots_[k].disc.radius), across = cosine(k, in, out);
      const Near bend = across.low() > 0 ? front + Near(2) / (radius * across) : anything();
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

  // Solves own[k] x[k] - shared[k - 1] x[k - 1] - shared[k] x[k + 1] = x[k] as given, between ends
  // that are 0.
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
    return {apart - share * radii, share, share, kInfinity};
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

  // The cosine of the angle at a bounce, which is half of that between the ways to and from it;
  // where the bounce is taken to be these make angles that differ by its slope.
  Near cosine(std::size_t k, const Leg& in, const Leg& out) const {
    const Near& into = legs_[k - 1].into;
    return turned(into,
                  (in.turn + out.turn) / 2 + slope_[k] / (spots_[k].disc.radius * into.low()));
  }

  // The slope at each bounce, 0 of an orbit, is what it is where the bounces are taken to be, and
  // second derivatives between there and the orbit times what is off: so much of one is off at
  // most, where so much of its neighbours is.
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

OrbitStep middle_step(const OpenDiscs& discs, const Word& word) {
  return WordOrbit(discs, word).middle_step();
}

}  // namespace flatray
