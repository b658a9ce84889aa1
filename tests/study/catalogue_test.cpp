#include <gtest/gtest.h>

#include <string>

#include "study/catalogue_check.h"

namespace flatray {
namespace {

TEST(Catalogue, HasEveryNumberOnceAndInOrder) {
  std::vector<std::string> ids;
  for (const oracle::StiffCase& stiff : oracle::catalogue()) ids.emplace_back(stiff.id);
  std::vector<std::string> expected;
  const std::pair<char, int> parts[] = {{'A', 16}, {'B', 13}, {'C', 32}, {'D', 9}, {'E', 11}};
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
      EXPECT_LE(tallies[k].worst_ulps, 1) << stiff.id << " " << exact[k]->name;
      EXPECT_EQ(tallies[k].queries > 0, stiff.concerns_tracers()) << stiff.id;
    }
  }
}

}  // namespace
}  // namespace flatray
