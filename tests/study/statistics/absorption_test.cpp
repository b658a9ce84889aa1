#include "study/statistics/absorption.h"

#include <gtest/gtest.h>

#include "study/chains.h"

namespace flatray {
namespace {

using namespace flatray::testing;

std::vector<std::optional<Absorption>> steps_to_end(const StepMatrix& steps) {
  return steps_to_absorption(steps, absorbing_states(steps));
}

std::vector<std::string> expected_texts(const StepMatrix& steps) {
  std::vector<std::string> texts;
  for (const std::optional<Absorption>& from : steps_to_end(steps))
    texts.push_back(from ? from->expected.text() : "infinite");
  return texts;
}

// Facts, section 8: the nine fractions that tell the three repairs of RUNNING apart.
TEST(Absorption, MeetsTheNineFractionsOfTheRepairedPaperChain) {
  using Texts = std::vector<std::string>;
  const std::vector<Texts> facts = {{"1060/189", "100/21", "4/3", "0"},
                                    {"500/93", "140/31", "4/3", "0"},
                                    {"949/186", "131/31", "4/3", "0"}};
  const std::vector<MarkovChain> chains = paper_chains();
  for (std::size_t i = 0; i < 3; ++i) {
    const std::optional<StepMatrix> given = given_probabilities(chains[i]);
    ASSERT_TRUE(given.has_value());
    EXPECT_EQ(expected_texts(*given), facts[i]) << chains[i].name;
  }
}

TEST(Absorption, TheDrawsMeetTheGivenProbabilitiesToTheirLastBit) {
  for (const MarkovChain& chain : paper_chains()) {
    const StepMatrix drawn = drawn_probabilities(chain);
    const StepMatrix given = given_probabilities(chain).value();
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      Rational sum;
      for (std::size_t j = 0; j < drawn.size(); ++j) {
        sum += drawn[i][j];
        const Rational error = drawn[i][j] - given[i][j];
        EXPECT_LE((error * error).nearest(), 0x1p-128);
      }
      EXPECT_EQ(sum, Rational(1));
    }
  }
}

TEST(Absorption, ProbabilitiesWithoutFractionsAreTheSimplestThatRoundToThem) {
  for (MarkovChain chain : paper_chains()) {
    const StepMatrix given = given_probabilities(chain).value();
    chain.fractions.clear();
    EXPECT_EQ(given_probabilities(chain), given);
  }
}

TEST(Absorption, FractionsThatDoNotSumToOneAreNotBelieved) {
  MarkovChain chain = paper_chains()[0];
  chain.fractions[1][0] = "0";  // the paper's 0.91
  EXPECT_EQ(given_probabilities(chain), std::nullopt);
  for (const char* wrong : {"", "1/0", "-1", "0.5", "1/", "/2"}) {
    chain = chain_of("wrong", {"A"}, {{"1"}});
    chain.fractions[0][0] = wrong;
    EXPECT_EQ(given_probabilities(chain), std::nullopt) << wrong;
  }
}

// A geometric wait: mean 1/p, variance (1 - p)/p^2.
TEST(Absorption, AWaitIsGeometric) {
  const MarkovChain wait = chain_of("wait", {"WAIT", "END"}, {{"6/7", "1/7"}, {"0", "1"}});
  const Absorption found = steps_to_end(*given_probabilities(wait))[0].value();
  EXPECT_EQ(found.expected.text(), "7");
  EXPECT_EQ(found.variance.text(), "42");
}

TEST(Absorption, AStraightRoadHasNoVariance) {
  const MarkovChain road = chain_of(
      "road", {"A", "B", "C", "END"},
      {{"0", "1", "0", "0"}, {"0", "0", "1", "0"}, {"0", "0", "0", "1"}, {"0", "0", "0", "1"}});
  const auto found = steps_to_end(*given_probabilities(road));
  EXPECT_EQ(found[0]->expected.text(), "3");
  EXPECT_EQ(found[0]->variance.text(), "0");
}

TEST(Absorption, WhereItIsNotCertainTheNumberIsInfinite) {
  const auto texts = [](std::vector<std::vector<std::string>> fractions) {
    std::vector<std::string> states(fractions.size(), "S");
    return expected_texts(*given_probabilities(chain_of("c", states, std::move(fractions))));
  };
  using Texts = std::vector<std::string>;
  // Two states that only know each other.
  EXPECT_EQ(texts({{"0", "1"}, {"1", "0"}}), (Texts{"infinite", "infinite"}));
  // A may fall into the trap B-C or end in D; D's neighbour E only ends.
  EXPECT_EQ(texts({{"0", "1/2", "0", "1/2", "0"},
                   {"0", "0", "1", "0", "0"},
                   {"0", "1", "0", "0", "0"},
                   {"0", "0", "0", "1", "0"},
                   {"0", "0", "0", "1", "0"}}),
            (Texts{"infinite", "infinite", "infinite", "0", "1"}));
}

TEST(Absorption, AGamblerIsRuinedInThePositionsTimesTheRestOfThem) {
  // Fair steps on 0..8 until an end: from k it takes k * (8 - k) steps.
  std::vector<std::vector<std::string>> fractions(9, std::vector<std::string>(9, "0"));
  fractions[0][0] = fractions[8][8] = "1";
  for (std::size_t k = 1; k < 8; ++k) fractions[k][k - 1] = fractions[k][k + 1] = "1/2";
  const MarkovChain gambler = chain_of("g", std::vector<std::string>(9, "S"), fractions);
  const auto found = steps_to_end(*given_probabilities(gambler));
  for (std::size_t k = 0; k <= 8; ++k)
    EXPECT_EQ(found[k]->expected, Rational(static_cast<double>(k * (8 - k))));
}

}  // namespace
}  // namespace flatray
