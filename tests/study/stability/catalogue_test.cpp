#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "precise/certified_orbit.h"
#include "study/spoiled_tracer.h"
#include "study/stability/catalogue_check.h"
#include "trace/many_rays.h"

namespace flatray {
namespace {

TEST(Catalogue, HasEveryNumberOnceAndInOrder) {
  std::vector<std::string> ids;
  for (const oracle::StiffCase& stiff : oracle::catalogue()) ids.emplace_back(stiff.id);
  std::vector<std::string> expected;
  const std::pair<char, int> parts[] = {{'A', 16}, {'B', 13}, {'C', 32},
                                        {'D', 9},  {'E', 11}, {'F', 6}};
  for (const auto& [letter, count] : parts)
    for (int i = 1; i <= count; ++i) expected.push_back(letter + std::to_string(i));
  EXPECT_EQ(ids, expected);
}

TEST(Catalogue, ExactTracersAreRightInAllOfIt) {
  std::vector<const Tracer*> exact;
  for (const Tracer* tracer : tracers())
    if (tracer->exact && std::string(tracer->name) != "exact") exact.push_back(tracer);
  for (const oracle::StiffCase& stiff : oracle::catalogue()) {
    const std::vector<CatalogueTally> tallies = check_case(stiff, exact);
    for (std::size_t k = 0; k < exact.size(); ++k) {
      EXPECT_EQ(tallies[k].wrong, 0U) << stiff.id << " " << exact[k]->name;
      EXPECT_EQ(tallies[k].leaks, 0U) << stiff.id << " " << exact[k]->name;
      EXPECT_EQ(tallies[k].apart, 0U) << stiff.id << " " << exact[k]->name;
      EXPECT_LE(tallies[k].worst_ulps(), 1) << stiff.id << " " << exact[k]->name;
      EXPECT_EQ(tallies[k].queries > 0, stiff.concerns_tracers()) << stiff.id;
      EXPECT_EQ(tallies[k].right(), true) << stiff.id << " " << exact[k]->name;
    }
  }
}

const oracle::StiffCase& named(const std::vector<oracle::StiffCase>& cases, const std::string& id) {
  return *std::find_if(cases.begin(), cases.end(),
                       [&](const oracle::StiffCase& one) { return one.id == id; });
}

// Another wall where it is asked for many rays at once.
void swap_walls_of_many(std::span<NearestHit> hits) {
  if (hits.size() <= kMostRaysOneByOne) return;
  for (NearestHit& hit : hits)
    if (hit) hit.surface = hit.surface == 0 ? 1 : 0;
}

TEST(Catalogue, AsksEveryCaseAlsoInBatchesLongEnoughForLanes) {
  const std::vector<oracle::StiffCase> cases = oracle::catalogue();
  const Tracer wrong = testing::spoiled_by<&swap_walls_of_many>();
  const Tracer* const asked[] = {&wrong};
  const CatalogueTally rays = check_case(named(cases, "B4"), asked).front();
  EXPECT_EQ(rays.wrong, rays.in_batches);
  EXPECT_EQ(rays.apart, rays.in_batches);
  EXPECT_GT(rays.queries, rays.in_batches);
  const CatalogueTally orbits = check_case(named(cases, "C1"), asked).front();
  EXPECT_GE(orbits.wrong, kMostRaysOneByOne);  // the orbits of copies
  EXPECT_GT(orbits.apart, orbits.in_batches);  // those and every leg
}

TEST(Catalogue, CertifiedOrbitsAreRightInAllOfIt) {
  if (!can_certify()) GTEST_SKIP() << "no MPFR";
  for (const oracle::StiffCase& stiff : oracle::catalogue()) {
    const auto tally = check_certified(stiff);
    ASSERT_TRUE(tally);
    EXPECT_TRUE(tally->right()) << stiff.id;
    EXPECT_EQ(tally->queries > 0, !stiff.orbits.empty()) << stiff.id;
  }
}

TEST(Catalogue, ContactsAreRightInAllOfIt) {
  for (const oracle::StiffCase& stiff : oracle::catalogue()) {
    const CatalogueTally tally = check_contacts(stiff);
    EXPECT_TRUE(tally.right()) << stiff.id << ": " << tally.wrong << " wrong, " << tally.apart
                               << " apart, " << tally.worst_ulps() << " ulps";
    EXPECT_EQ(tally.queries, 65 * stiff.contacts.size()) << stiff.id;
  }
}

// What can be asked has figures; the rest says what it is about instead.
TEST(Catalogue, HasFiguresOrSaysWhyNot) {
  std::size_t with_figures = 0;
  for (const oracle::StiffCase& stiff : oracle::catalogue()) {
    const bool asked = stiff.concerns_tracers() || !stiff.contacts.empty();
    with_figures += asked ? 1 : 0;
    EXPECT_EQ(asked, std::string(stiff.matter).empty()) << stiff.id;
    EXPECT_EQ(asked, stiff.id[0] != 'E') << stiff.id;
  }
  EXPECT_EQ(with_figures, 76U);
}

// A case whose truth is another: the check has to see it.
TEST(Catalogue, AWrongTruthOfAContactIsSeen) {
  oracle::StiffCase stiff = named(oracle::catalogue(), "D1");
  const double first = stiff.contacts.front().first;
  stiff.contacts.front().first = std::nextafter(std::nextafter(first, 1.0), 1.0);
  EXPECT_GT(check_contacts(stiff).worst_ulps(), 1);
  stiff.contacts.front().kind = HitClass::touch;
  EXPECT_EQ(check_contacts(stiff).wrong, 65U);
}

// After 200 bounces among curves no digit of a chaotic orbit is left: it does not lead back.
TEST(Catalogue, AWayBackOverOtherWallsIsSeen) {
  oracle::StiffCase stiff = named(oracle::catalogue(), "C22");
  const Tracer* const brute[] = {find_tracer("brute")};
  EXPECT_EQ(check_case(stiff, brute).front().wrong, 0U);
  std::size_t starts = 0;
  for (oracle::StiffOrbits& orbits : stiff.orbits) {
    orbits.there_and_back = true;
    starts += orbits.starts.size();
  }
  EXPECT_EQ(check_case(stiff, brute).front().wrong, starts);
}

TEST(CatalogueTally, OneAnswerInAThousandMayBeFartherOffThanMost) {
  CatalogueTally tally;
  tally.ulps.assign(999, 0.5);
  tally.add({.ulps = {7}});
  EXPECT_EQ(tally.worst_ulps(), 7);
  EXPECT_EQ(tally.most_ulps(), 0.5);
  tally.ulps.erase(tally.ulps.begin());
  EXPECT_EQ(tally.most_ulps(), 7);
}

}  // namespace
}  // namespace flatray
