#include "study/stability/pair_stability.h"

#include <fmt/core.h>

#include <cmath>

#include "collide/contact_batch.h"
#include "collide/turning_contact.h"
#include "oracle/contact.h"
#include "oracle/moving_pairs.h"
#include "oracle/turning_pairs.h"

namespace flatray {
namespace {

void add_wrong(StabilityTally& tally, std::uint64_t item) {
  ++tally.wrong;
  if (tally.first_wrong.empty()) tally.first_wrong = fmt::format("item {}", item);
}

// An end of the times that lies within the domain.
void check_time(StabilityTally& tally, double t, const std::optional<Rational>& truth) {
  if (!truth) return;
  const double nearest = truth->nearest();
  if (t == nearest || !std::isfinite(nearest)) return;
  ++tally.not_nearest;
  if (t != std::nextafter(nearest, t)) ++tally.off_by_more;
}

// Whether class and start are right.
template <class Truth>
bool count_verdict(StabilityTally& tally, std::uint64_t item, const HitInterval& met,
                   const Truth& truth) {
  ++tally.rays;
  const bool touches = truth.kind != HitClass::miss;
  tally.hits += touches ? 1 : 0;
  if (met.kind != truth.kind || met.start != truth.start) {
    add_wrong(tally, item);
    if (touches && !met)
      ++tally.missed;
    else if (!touches && met)
      ++tally.invented;
    else
      ++tally.other_wall;
    return false;
  }
  return true;
}

// Of round bodies that overlap for a while: an ulp outside of it they do not, an ulp inside they
// are not apart, where it lasts as long.
void check_while(StabilityTally& tally, const oracle::StraightPair& pair, const HitInterval& met) {
  const auto apart = [&](double at) { return oracle::apart_at(pair.a(), pair.b(), Rational(at)); };
  const double in = std::nextafter(met.t_enter, kInfinity),
               out = std::nextafter(met.t_exit, -kInfinity);
  const auto is_off = [&](double outside, double inside) {
    return apart(outside) == Sign::negative || (in <= out && apart(inside) == Sign::positive);
  };
  if (met.t_enter != 0 && is_off(std::nextafter(met.t_enter, -kInfinity), in)) ++tally.off_by_more;
  if (std::isfinite(met.t_exit) && is_off(std::nextafter(met.t_exit, kInfinity), out))
    ++tally.off_by_more;
}

void compare(StabilityTally& tally, std::uint64_t item, const HitInterval& met,
             const oracle::StraightPair& pair, const oracle::ContactTruth& truth) {
  if (!count_verdict(tally, item, met, truth) || !met) return;
  check_time(tally, met.t_enter, truth.first);
  check_time(tally, met.t_exit, truth.last);
  const bool is_round = pair.radius_a > 0 || pair.radius_b > 0;
  if (is_round && met.kind == HitClass::through && pair.velocity_a != pair.velocity_b)
    check_while(tally, pair, met);
}

MovingBody body(const oracle::MovingCore& core) { return {core.ring, core.velocity, core.radius}; }

// One by one, and where there is a second tally together.
void check_straight(const oracle::StraightFamily& family, std::uint64_t seed, std::uint64_t first,
                    std::uint64_t count, std::vector<StabilityTally>& tallies) {
  std::vector<oracle::StraightPair> pairs;
  BodySet shapes;
  std::vector<MovingPair> asks;
  for (std::uint64_t item = first; item < first + count; ++item) {
    const oracle::StraightPair& pair = pairs.emplace_back(oracle::make_pair(family, seed, item));
    const std::uint32_t a = shapes.add(pair.ring_a, pair.radius_a),
                        b = shapes.add(pair.ring_b, pair.radius_b);
    asks.push_back({a, b, pair.velocity_a, pair.velocity_b});
  }
  std::vector<Contact> together(asks.size());
  if (tallies.size() > 1) contacts(shapes, asks, kRay, together);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const oracle::StraightPair& pair = pairs[i];
    const oracle::ContactTruth truth = oracle::contact_truth(pair.a(), pair.b(), kRay);
    compare(tallies[0], first + i, contact(body(pair.a()), body(pair.b())).times, pair, truth);
    if (tallies.size() > 1) compare(tallies[1], first + i, together[i].times, pair, truth);
  }
}

TurningBody body(const oracle::TurningCore& core) {
  return {core.ring, core.radius, even_motion(core.at, core.velocity, core.angle, core.spin)};
}

void compare(StabilityTally& tally, std::uint64_t item, const oracle::TurningPair& pair) {
  using Verdict = TurningContact::Verdict;
  using Kind = oracle::FirstTouch::Kind;
  const TurningContact met = turning_contact(body(pair.a), body(pair.b), 1, kAskedWidth);
  const oracle::FirstTouch truth = oracle::first_touch(pair.a, pair.b, 1);
  ++tally.rays;
  tally.hits += truth.kind == Kind::touch ? 1 : 0;
  if (met.verdict == Verdict::undecided || truth.kind == Kind::unknown) ++tally.by_rationals;
  const bool meets = met.verdict == Verdict::meets;
  bool wrong = meets && oracle::apart_at(pair.a, pair.b, met.first.high) > 0;
  if (truth.kind == Kind::touch) {
    const bool held = met.first.low <= truth.high && met.first.high >= truth.low;
    if (met.verdict == Verdict::apart || !held) ++tally.missed;
    wrong = wrong || met.verdict == Verdict::apart || !held;
  }
  if (truth.kind == Kind::none && meets) {
    ++tally.invented;
    wrong = true;
  }
  if (wrong) add_wrong(tally, item);
  if (meets && met.first.high - met.first.low > kAskedWidth) ++tally.not_nearest;
}

}  // namespace

std::vector<PairFamily> pair_families() {
  std::vector<PairFamily> all;
  for (const auto& family : oracle::straight_families())
    all.push_back({family.name, {"contact", "contacts"}});
  for (const auto& family : oracle::round_families()) all.push_back({family.name, {"contact"}});
  for (const auto& family : oracle::turning_families()) all.push_back({family.name, {"turning"}});
  return all;
}

std::vector<StabilityTally> check_pairs(const PairFamily& family, std::uint64_t seed,
                                        std::uint64_t first, std::uint64_t count) {
  std::vector<StabilityTally> tallies(family.methods.size());
  for (const auto& families : {oracle::straight_families(), oracle::round_families()})
    for (const auto& straight : families)
      if (family.name == straight.name) check_straight(straight, seed, first, count, tallies);
  for (const auto& turning : oracle::turning_families())
    for (std::uint64_t i = first; family.name == turning.name && i < first + count; ++i)
      compare(tallies[0], i, oracle::make_pair(turning, seed, i));
  return tallies;
}

}  // namespace flatray
