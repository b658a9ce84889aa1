#include "collide/impact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geom/ray.h"
#include "oracle/families.h"

namespace flatray {
namespace {

using oracle::Draw;

double energy(std::span<const ImpactBody> bodies, std::span<const Vec2> velocities) {
  double sum = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (bodies[i].mass < kInfinity) sum += 0.5 * bodies[i].mass * velocities[i].squaredNorm();
  return sum;
}
Vec2 momentum(std::span<const ImpactBody> bodies, std::span<const Vec2> velocities) {
  Vec2 sum(0, 0);
  for (std::size_t i = 0; i < bodies.size(); ++i) sum += bodies[i].mass * velocities[i];
  return sum;
}
std::vector<Vec2> before(std::span<const ImpactBody> bodies) {
  std::vector<Vec2> velocities;
  for (const ImpactBody& body : bodies) velocities.push_back(body.velocity);
  return velocities;
}
double parting(const ImpactContact& contact, std::span<const Vec2> velocities) {
  return contact.normal.dot(velocities[contact.b] - velocities[contact.a]);
}

struct Cluster {
  std::vector<ImpactBody> bodies;
  std::vector<ImpactContact> contacts;
};

// Up to four bodies of any masses, each but the first touching one or two of those before.
Cluster cluster(std::uint64_t item, bool slides) {
  Draw draw(31, slides ? 2 : 1, item);
  Cluster found;
  const auto count = static_cast<std::uint32_t>(2 + draw.below(3));
  for (std::uint32_t i = 0; i < count; ++i) {
    const double x = draw.unit() - 0.5, y = draw.unit() - 0.5;
    found.bodies.push_back({{x, y}, 0.25 + 4 * draw.unit()});
    for (std::uint32_t k = 0; i > 0 && k < std::min(i, 2U); ++k) {
      const double angle = 6.28 * draw.unit();
      const auto other = static_cast<std::uint32_t>(draw.below(static_cast<int>(i)));
      found.contacts.push_back({other, i, {std::cos(angle), std::sin(angle)}, slides});
    }
  }
  return found;
}

// The same with bodies and contacts in another order, some contacts turned round.
Cluster shuffled(const Cluster& given, std::uint64_t item, std::vector<std::uint32_t>& place) {
  Draw draw(32, 1, item);
  place.resize(given.bodies.size());
  std::iota(place.begin(), place.end(), 0U);
  for (std::size_t i = place.size(); i > 1; --i)
    std::swap(place[i - 1], place[static_cast<std::size_t>(draw.below(static_cast<int>(i)))]);
  Cluster found{std::vector<ImpactBody>(given.bodies.size()), {}};
  for (std::size_t i = 0; i < place.size(); ++i) found.bodies[place[i]] = given.bodies[i];
  for (const auto& [a, b, normal, slides] : given.contacts)
    if (draw.unit() < 0.5)
      found.contacts.push_back({place[a], place[b], normal, slides});
    else
      found.contacts.push_back({place[b], place[a], -normal, slides});
  std::reverse(found.contacts.begin(), found.contacts.end());
  return found;
}

// Momentum and energy, by symmetry: each disc gets p along (4, 3) / 5 or its mirror image, 57 p = 8 * 5.
TEST(Impact, ACueBetweenTwoDiscsLeavesAtTheRational) {
  std::vector<std::uint32_t> order{0, 1, 2};
  do {
    std::vector<ImpactBody> bodies(3, {{0, 0}, 1});
    bodies[order[0]].velocity = {1, 0};
    const ImpactContact up{order[0], order[1], {4, 3}, false},
        down{order[0], order[2], {4, -3}, false};
    for (const auto& contacts : {std::vector{up, down}, std::vector{down, up}}) {
      const auto impact = solve_impact(bodies, contacts);
      ASSERT_TRUE(impact);
      EXPECT_EQ(impact->velocities[order[0]], Vec2(-7.0 / 57, 0));
      EXPECT_EQ(impact->velocities[order[1]], Vec2(32.0 / 57, 24.0 / 57));
      EXPECT_EQ(impact->velocities[order[2]], Vec2(32.0 / 57, -24.0 / 57));
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(Impact, BouncesTogetherKeepMomentumAndEnergy) {
  for (std::uint64_t item = 0; item < 150; ++item) {
    const auto [bodies, contacts] = cluster(item, false);
    const auto impact = solve_impact(bodies, contacts);
    ASSERT_TRUE(impact) << item;
    const double whole = energy(bodies, before(bodies));
    EXPECT_NEAR(energy(bodies, impact->velocities), whole, 16 * 0x1p-52 * whole) << item;
    EXPECT_LE((momentum(bodies, impact->velocities) - momentum(bodies, before(bodies))).norm(),
              64 * 0x1p-52)
        << item;
    for (const ImpactContact& contact : contacts) {
      const double came = std::min(parting(contact, before(bodies)), 0.0);
      EXPECT_TRUE(came == 0 || parting(contact, impact->velocities) >= -came - 1e-14) << item;
    }
  }
}

// What slides goes to the nearest velocities, as energy measures it, at which none comes nearer.
TEST(Impact, WhatSlidesLosesTheEnergyOfWhatItLoses) {
  for (std::uint64_t item = 0; item < 150; ++item) {
    const auto [bodies, contacts] = cluster(item, true);
    const auto impact = solve_impact(bodies, contacts);
    ASSERT_TRUE(impact) << item;
    std::vector<Vec2> lost = before(bodies);
    for (std::size_t i = 0; i < lost.size(); ++i) lost[i] -= impact->velocities[i];
    const double whole = energy(bodies, before(bodies));
    EXPECT_NEAR(energy(bodies, impact->velocities) + energy(bodies, lost), whole, 1e-10 * whole);
    EXPECT_LE((momentum(bodies, lost)).norm(), 64 * 0x1p-52) << item;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const double parts = parting(contacts[i], impact->velocities);
      EXPECT_GE(parts, 0) << item;
      EXPECT_EQ(impact->rests[i], parts < 1e-11) << item << ' ' << parts;
    }
  }
}

TEST(Impact, NoOrderMatters) {
  for (std::uint64_t item = 0; item < 100; ++item)
    for (const bool slides : {false, true}) {
      const Cluster one = cluster(item, slides);
      std::vector<std::uint32_t> place;
      const Cluster other = shuffled(one, item, place);
      const auto first = solve_impact(one.bodies, one.contacts),
                 second = solve_impact(other.bodies, other.contacts);
      ASSERT_TRUE(first && second);
      for (std::size_t i = 0; i < place.size(); ++i)
        EXPECT_EQ(first->velocities[i], second->velocities[place[i]]) << item;
    }
}

TEST(Impact, APileComesToRestExactlyWhateverTheMasses) {
  for (const std::uint32_t count : {1U, 2U, 3U, 7U, 40U, 200U}) {
    std::vector<ImpactBody> bodies{{{0, 0}, kInfinity}};
    std::vector<ImpactContact> contacts;
    for (std::uint32_t i = 1; i <= count; ++i) {
      bodies.push_back({{0.25, -0.1 * i}, 0.1 * (1 + i * i % 7)});
      contacts.push_back({i - 1, i, {0, 1}, true});
    }
    const auto impact = solve_impact(bodies, contacts);
    ASSERT_TRUE(impact);
    for (std::uint32_t i = 1; i <= count; ++i)
      EXPECT_EQ(impact->velocities[i], Vec2(0.25, 0)) << count;
    EXPECT_EQ(std::count(impact->rests.begin(), impact->rests.end(), true), count);
  }
}

// Two of three feet more than it needs.
TEST(Impact, ContactsMoreThanItTakesChangeNothing) {
  const std::vector<ImpactBody> bodies{{{0, 0}, kInfinity}, {{1, -1}, 3}, {{0, -4}, 0.3}};
  const ImpactContact foot{0, 1, {0, 1}, true}, top{1, 2, {0, 2}, true};
  for (const auto& contacts : {std::vector{foot, top}, std::vector{foot, foot, top, foot, top}}) {
    const auto impact = solve_impact(bodies, contacts);
    ASSERT_TRUE(impact);
    EXPECT_EQ(impact->velocities[1], Vec2(1, 0));
    EXPECT_EQ(impact->velocities[2], Vec2(0, 0));
  }
}

TEST(Impact, BetweenWallsThatCloseInThereIsNoWayOut) {
  for (const bool slides : {false, true}) {
    std::vector<ImpactBody> bodies{{{1, 0}, kInfinity}, {{0, 0}, 1}, {{-1, 0}, kInfinity}};
    const ImpactContact contacts[] = {{0, 1, {1, 0}, slides}, {1, 2, {1, 0}, slides}};
    EXPECT_FALSE(solve_impact(bodies, contacts));
    bodies[2].velocity = {1, 0};  // goes on ahead
    EXPECT_TRUE(solve_impact(bodies, contacts));
  }
}

// More contacts than are solved in rationals: doubles, to rounding.
TEST(Impact, AGridOfManyBouncesKeepsMomentumAndEnergy) {
  constexpr std::uint32_t kAcross = 16;
  std::vector<ImpactBody> bodies;
  std::vector<ImpactContact> contacts;
  for (std::uint32_t i = 0; i < kAcross * kAcross; ++i) {
    Draw draw(33, 1, i);
    const double x = i % kAcross, y = i / kAcross;
    const Vec2 centre(7.5 - x, 7.5 - y);
    const double faster = 0.5 + draw.unit();
    bodies.push_back({faster * centre, 0.5 + draw.unit()});
    const double tilt = 0.2 * draw.unit();
    if (i % kAcross > 0) contacts.push_back({i - 1, i, {1, tilt}, false});
    if (i >= kAcross) contacts.push_back({i - kAcross, i, {tilt, 1}, false});
  }
  const auto impact = solve_impact(bodies, contacts);
  ASSERT_TRUE(impact);
  const double whole = energy(bodies, before(bodies));
  EXPECT_NEAR(energy(bodies, impact->velocities), whole, 1e-9 * whole);
  EXPECT_LE((momentum(bodies, impact->velocities) - momentum(bodies, before(bodies))).norm(),
            1e-10);
}

}  // namespace
}  // namespace flatray
