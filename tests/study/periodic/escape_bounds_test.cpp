// needs: shapes/circle experiments/periodic
// Proven bounds of escape rates, and enclosures of legs by words, against closed forms, cycle expansions
// and longer words.
#include "study/periodic/escape_bounds.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>
#include <utility>

#include "base/philox.h"
#include "full_counts.h"
#include "study/chamber_scenes.h"
#include "study/periodic/cycle_expansion.h"
#include "study/periodic/disc_words.h"
#include "study/periodic/words.h"

namespace flatray {
namespace {

using namespace flatray::testing;

// A scene and its mirrors, which point into it.
struct DiscRoom {
  explicit DiscRoom(const std::vector<Circle>& discs) : scene(scene_of(text(discs))), room(scene) {}
  static std::string text(const std::vector<Circle>& discs) {
    std::string all;
    for (const Circle& one : discs)
      all += mirror_disc(fmt::format("{}, {}", one.centre.x(), one.centre.y()),
                         fmt::format("{}", one.radius));
    return all;
  }
  // Of three discs by words of so many bounces.
  auto bounds(std::size_t bounces, double about) const {
    return escape_bounds({scene}, mirrors, std::size_t{3} << (bounces - 1), about);
  }
  Scene scene;
  Room room;
  MirrorRoom mirrors = *MirrorRoom::of(room);
};

DiscRoom three_discs(double apart) {
  const double root = std::sqrt(3.0);
  return DiscRoom({{{apart / root, 0}, 1},
                   {{-apart / (2 * root), apart / 2}, 1},
                   {{-apart / (2 * root), -apart / 2}, 1}});
}

double draw(std::uint64_t seed, std::uint32_t number, double low, double high) {
  return low + (high - low) * unit_double(random_bits(seed, Stream::experiment, 0, 0, number));
}

// Three or four discs of random radii, far apart.
DiscRoom random_discs(std::uint64_t seed) {
  std::vector<Circle> discs;
  const Vec2 places[] = {{0, 0}, {8, 0}, {4, 7}, {5, -8}};
  const std::size_t count = seed % 2 == 0 ? 3 : 4;
  for (std::uint32_t i = 0; i < count; ++i)
    discs.push_back(
        {places[i] + Vec2(draw(seed, 3 * i, -0.5, 0.5), draw(seed, 3 * i + 1, -0.5, 0.5)),
         draw(seed, 3 * i + 2, 0.5, 1.2)});
  return DiscRoom(discs);
}

void expect_holds(const Range& range, double truth, double most_wide) {
  EXPECT_LT(range.low, truth);
  EXPECT_GT(range.high, truth);
  EXPECT_LT(range.high - range.low, most_wide);
}

// Source: Chaos: Classical and Quantum, 0.41033840776934648933846 for R : a = 6; by bounce, the cycle
// expansion up to 12. Two bounces more give a digit.
TEST(EscapeBounds, HoldThePublishedRateOfThreeDiscs) {
  const DiscRoom room = three_discs(6);
  double wide = 3e-3;
  for (std::size_t bounces = 6; bounces <= 14; bounces += 2, wide /= 10) {
    const auto bounds = room.bounds(bounces, 0.4103384);
    ASSERT_TRUE(bounds.has_value()) << bounds.error();
    EXPECT_EQ(bounds->bounces, bounces);
    expect_holds(bounds->per_length, 0.41033840776934649, 2 * wide);
    expect_holds(bounds->per_bounce, 1.6981063230203446, 8 * wide);
  }
}

// Also where the gaps between the discs are as wide as these, or half as wide. By cycle expansion up to 9 and 12 bounces.
TEST(EscapeBounds, HoldWhereDiscsAreNear) {
  const std::tuple<double, double, double, double, double> kKnown[] = {
      {3, 0.6779226896, 0.783594040245, 1e-3, 1e-3},
      {2.5, 0.723842717014, 0.481165699433, 3e-2, 2e-2}};
  for (const auto& [apart, by_length, by_bounce, wide_length, wide_bounce] : kKnown) {
    const auto bounds = three_discs(apart).bounds(13, by_length);
    ASSERT_TRUE(bounds.has_value()) << bounds.error();
    expect_holds(bounds->per_length, by_length, wide_length);
    expect_holds(bounds->per_bounce, by_bounce, wide_bounce);
  }
}

// Wherever the rate is looked for; far from it bounds are wider.
TEST(EscapeBounds, HoldTheRateFromAnywhere) {
  const DiscRoom room = three_discs(6);
  for (const double about : {0.2, 0.39, 0.43, 0.6}) {
    const auto bounds = room.bounds(12, about);
    ASSERT_TRUE(bounds.has_value()) << bounds.error();
    expect_holds(bounds->per_length, 0.41033840776934649, 0.1 * std::fabs(about - 0.41));
    expect_holds(bounds->per_bounce, 1.6981063230203446, 1e-4);
  }
}

// The rate a bounce is open, on either side, by what words leave open of their weights, in the mean.
TEST(EscapeBounds, AreAsWideAsWordsLeaveOpen) {
  const DiscRoom room = three_discs(6);
  const auto discs = OpenDiscs::of(room.mirrors);
  constexpr double kRate = 0.4103384;
  const auto bounds = room.bounds(6, kRate);
  ASSERT_TRUE(discs && bounds);
  double mean = 0;
  for (int turns = 0; turns < 32; ++turns) {
    Word word{0};
    for (int i = 0; i < 5; ++i)
      word.push_back(static_cast<std::uint8_t>((word.back() + 1 + (turns >> i & 1)) % 3));
    const OrbitStep step = middle_step(*discs, word);
    mean += (kRate * step.length.error() + step.stretch.error() / step.stretch.low()) / 32;
  }
  EXPECT_NEAR((bounds->per_bounce.high - bounds->per_bounce.low) / 2, mean, 0.1 * mean);
}

// To and fro between two discs 4 apart is the one orbit, which parts neighbours 5 + 2 sqrt(6) times a bounce.
TEST(EscapeBounds, HoldTheClosedFormOfTwoDiscs) {
  const auto bounds = DiscRoom({{{0, 0}, 1}, {{6, 0}, 1}}).bounds(10, 0.57);
  ASSERT_TRUE(bounds.has_value()) << bounds.error();
  const double stretch = std::log(5 + 2 * std::sqrt(6.0));
  expect_holds(bounds->per_length, stretch / 4, 1e-12);
  expect_holds(bounds->per_bounce, stretch, 1e-12);
}

// A room 2^k times as large has a rate 2^k times as small; one that is moved has the same.
TEST(EscapeBounds, GoWithTheSizeOfTheRoom) {
  const auto one = DiscRoom({{{0, 0}, 1}, {{6, 0}, 1}, {{2, 7}, 1}}).bounds(8, 0.4);
  const auto large =
      DiscRoom({{{0, 0}, 1024}, {{6144, 0}, 1024}, {{2048, 7168}, 1024}}).bounds(8, 0.4 / 1024);
  const auto moved = DiscRoom({{{512, 64}, 1}, {{518, 64}, 1}, {{514, 71}, 1}}).bounds(8, 0.4);
  ASSERT_TRUE(one && large && moved);
  EXPECT_DOUBLE_EQ(large->per_length.low * 1024, one->per_length.low);
  EXPECT_NEAR(large->per_bounce.high, one->per_bounce.high, 1e-14);
  EXPECT_NEAR(moved->per_length.low, one->per_length.low, 1e-13);
}

// The cycle expansion of all orbits up to eight bounces: where its last steps differ by less than what is proven
// is wide, it lies within.
TEST(EscapeBounds, HoldTheCycleExpansionOfRandomDiscs) {
  for (std::uint64_t seed = 1; seed <= times(6); ++seed) {
    const DiscRoom room = random_discs(seed);
    const std::size_t symbols = seed % 2 == 0 ? 9 : 7;
    std::vector<Cycle> cycles;
    const auto orbits = orbits_by_word({room.scene}, room.mirrors, symbols);
    ASSERT_TRUE(orbits.has_value());
    for (const ClosedOrbit& one : *orbits)
      cycles.push_back({one.word.size(), one.length.value(), one.eigenvalue()->value()});
    const auto means = cycle_means(cycles, symbols);
    const CycleMeans &last = means.back(), &before = means[means.size() - 2];
    const auto bounds = room.bounds(10, last.escape_rate);
    ASSERT_TRUE(bounds.has_value()) << bounds.error();
    expect_holds(bounds->per_length, last.escape_rate, 3e-3 * last.escape_rate);
    expect_holds(bounds->per_bounce, last.escape_rate_bounce, 1e-2 * last.escape_rate_bounce);
    EXPECT_LT(std::fabs(last.escape_rate - before.escape_rate),
              0.1 * (bounds->per_length.high - bounds->per_length.low));
  }
}

TEST(EscapeBounds, AreNoneWhereTheySayWhy) {
  const auto why = [](const std::vector<Circle>& discs) {
    const auto bounds = DiscRoom(discs).bounds(10, 0.4);
    return bounds ? std::string("none") : bounds.error();
  };
  EXPECT_TRUE(has(why({{{0, 0}, 1}, {{4, 0.25}, 1}, {{8, 0}, 1}}), "the way between two"));
  EXPECT_TRUE(has(why({{{0, 0}, 1}, {{2, 0}, 1}, {{8, 9}, 1}}), "near another"));
  EXPECT_TRUE(has(three_discs(2.35).bounds(6, 0.7).error(), "tell too little"));
}

void expect_longer_words_within(double apart) {
  const DiscRoom room = three_discs(apart);
  const auto discs = OpenDiscs::of(room.mirrors);
  ASSERT_TRUE(discs.has_value()) << discs.error();
  double nearest_length = 0, nearest_stretch = 0;
  const auto check = [](const Near& found, const Near& longer, double& nearest) {
    const double off = std::fabs(found.value() - longer.value());
    EXPECT_LE(off, found.error() + longer.error());
    nearest = std::max(nearest, off / found.error());
  };
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    Word longer;
    for (std::uint32_t i = 0; i < 24; ++i) {
      const int step = draw(seed, i, 0, 1) < 0.5 ? 1 : 2;
      longer.push_back(static_cast<std::uint8_t>(longer.empty() ? 0 : (longer.back() + step) % 3));
    }
    const OrbitStep truth = middle_step(*discs, longer);
    for (const std::size_t bounces : {6U, 8U, 12U}) {
      const auto from = longer.begin() + static_cast<std::ptrdiff_t>(12 - bounces / 2);
      const Word word(from, from + static_cast<std::ptrdiff_t>(bounces));
      const OrbitStep step = middle_step(*discs, word);
      check(step.length, truth.length, nearest_length);
      check(step.stretch, truth.stretch, nearest_stretch);
    }
  }
  EXPECT_GT(nearest_length, 0.3);
  EXPECT_GT(nearest_stretch, 0.3);
}

// What a word says of a leg holds where more of the word is known, and is no more careful than it must be: of some
// word the leg lies nearly as far from the middle as its error says.
TEST(DiscWords, EncloseWhatLongerWordsSay) {
  for (const double apart : {6.0, 2.6}) expect_longer_words_within(apart);
}

// Three discs of random radii round the origin, gaps from a tenth of them to as wide as they; every other time radii
// that differ twentyfold.
std::vector<Circle> near_discs(std::uint64_t seed) {
  const bool unlike = seed % 2 == 0;
  const double far = 1.2 * draw(seed, 0, 1.1, 2), least = unlike ? 0.05 : 0.5,
               most = unlike ? 1.6 : 1;
  std::vector<Circle> discs;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const double angle = 2.1 * i + draw(seed, 10 + i, -0.2, 0.2);
    discs.push_back(
        {far * Vec2(std::cos(angle), std::sin(angle)), draw(seed, 20 + i, least, most)});
  }
  return discs;
}

// How far a bounce of a closed orbit is from the middle of where the bounces before and after it say, as a part of
// what they leave open.
double part_of_arc(const OpenDiscs& discs, const ClosedOrbit& orbit, std::size_t at, int before,
                   int after) {
  const int length = static_cast<int>(orbit.word.size()), here = static_cast<int>(at);
  Word word;
  for (int i = here - before; i <= here + after; ++i)
    word.push_back(orbit.word[static_cast<std::size_t>((i + 6 * length) % length)]);
  const BounceArc& arc = discs.arc(word, static_cast<std::size_t>(before));
  const Vec2 place = orbit.points[at] - arc.disc.centre;
  EXPECT_NEAR(place.norm(), arc.disc.radius, 1e-9);
  return std::fabs(std::atan2(cross(arc.at, place), arc.at.dot(place))) / arc.off;
}

// Bounces of closed orbits are where the words in them say, and not all of them in the middle.
TEST(DiscWords, SayWhereBouncesAre) {
  std::size_t tried = 0;
  double farthest = 0;
  for (std::uint64_t seed = 51; seed <= 80; ++seed) {
    const DiscRoom room(near_discs(seed));
    const auto discs = OpenDiscs::of(room.mirrors);
    const auto orbits = orbits_by_word({room.scene}, room.mirrors, 6);
    if (!discs) continue;
    ++tried;
    for (const ClosedOrbit& orbit : *orbits)
      for (std::size_t at = 0; at < orbit.points.size(); ++at)
        for (const auto& [before, after] : {std::pair{1, 1}, {4, 4}, {0, 3}, {2, 0}, {1, 6}})
          farthest = std::max(farthest, part_of_arc(*discs, orbit, at, before, after));
  }
  EXPECT_GT(tried, 10U);
  EXPECT_LT(farthest, 1);
  EXPECT_GT(farthest, 0.8);
}

// Legs of a closed orbit, and what they stretch, make up its length and its eigenvalue.
TEST(DiscWords, MakeUpClosedOrbits) {
  const DiscRoom room = three_discs(6);
  const auto discs = OpenDiscs::of(room.mirrors);
  const Word turn{0, 1, 2, 1, 2};
  Near length(0.0), stretch(1.0);
  for (std::size_t start = 0; start < turn.size(); ++start) {
    Word word;
    for (std::size_t i = 0; i < 30; ++i) word.push_back(turn[(start + i) % turn.size()]);
    const OrbitStep step = middle_step(*discs, word);
    length = length + step.length;
    stretch = stretch * step.stretch;
  }
  const ClosedOrbit orbit = disc_orbit(room.mirrors, turn);
  EXPECT_NEAR(length.value(), orbit.length.value(), 1e-12);
  EXPECT_NEAR(stretch.value() / std::fabs(orbit.eigenvalue()->value()), 1, 1e-11);
}

}  // namespace
}  // namespace flatray
