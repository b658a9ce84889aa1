#include "scene/markov.h"

#include <gtest/gtest.h>

#include "base/file.h"
#include "scene_text.h"
#include "support/paths.h"

namespace flatray {
namespace {

std::string paper_chain(const std::string& settings = "") {
  return "flatray = 1\n[markov.paper]\n" + settings +
         "STANDING = { STANDING = 0.10, RUNNING = 0.85, DIE = 0.05 }\n"
         "RUNNING  = { RUNNING = 0.60, JUMP = 0.30, DIE = 0.01 }\n"
         "JUMP     = { JUMP = 0.25, DIE = 0.75 }\n"
         "DIE      = { DIE = 1 }\n";
}

// As the paper prints it: facts, section 8.
TEST(Markov, ThePaperChainIsRefusedNamingTheRowAndTheRepairs) {
  const auto result = load_scene(source_path("/tests/scene/refused/paper_chain.toml"));
  ASSERT_FALSE(result);
  ASSERT_EQ(result.error().size(), 1u) << format(result.error());
  const Diagnostic& problem = result.error()[0];
  EXPECT_EQ(problem.trouble, Trouble::invalid);
  EXPECT_EQ(problem.message, "transitions out of RUNNING sum to 0.91");
  EXPECT_EQ(problem.hint,
            R"(they must sum to 1: add 0.09, or say repair = "to-start", "to-self" or "scaled")");
  EXPECT_EQ(problem.where.source->text().substr(problem.where.offset, problem.where.length),
            "RUNNING");
}

using Row = std::vector<std::string>;

// Facts, section 8: the three repairs of RUNNING.
TEST(Markov, EachRepairGivesTheProbabilitiesAskedFor) {
  const auto running = [](const char* repair) {
    return loaded(paper_chain(std::string("repair = \"") + repair + "\"\n"))
        .scene.chains[0]
        .fractions[1];
  };
  EXPECT_EQ(running("to-start"), (Row{"9/100", "3/5", "3/10", "1/100"}));
  EXPECT_EQ(running("to-self"), (Row{"0", "69/100", "3/10", "1/100"}));
  EXPECT_EQ(running("scaled"), (Row{"0", "60/91", "30/91", "1/91"}));
}

TEST(Markov, RowsThatSumToOneAreLeftAloneByARepair) {
  const MarkovChain chain = loaded(paper_chain("repair = \"scaled\"\n")).scene.chains[0];
  EXPECT_EQ(chain.fractions[0], (Row{"1/10", "17/20", "0", "1/20"}));
  EXPECT_EQ(chain.fractions[3], (Row{"0", "0", "0", "1"}));
  EXPECT_EQ(chain.probabilities[0], (std::vector<double>{0.10, 0.85, 0, 0.05}));
}

// In doubles 0.7 + 0.2 + 0.1 is 0.9999999999999999.
TEST(Markov, DecimalsAreAddedExactly) {
  const MarkovChain chain = loaded(
                                "flatray = 1\n[markov.c]\nA = { A = 0.7, B = 0.2, C = 0.1 }\nB = { "
                                "B = 1 }\nC = { C = 1.0 }")
                                .scene.chains[0];
  EXPECT_EQ(chain.fractions[0], (Row{"7/10", "1/5", "1/10"}));
  const std::string shown = refusal(
      "flatray = 1\n[markov.c]\nA = { A = 0.99999999999999999999, B = 1e-21 }\nB = { B = 1 }\n");
  EXPECT_NE(shown.find("transitions out of A sum to 0.999999999999999999991"), std::string::npos)
      << shown;
}

TEST(Markov, CumulativesAreRoundedOnceToSixtyFourBits) {
  const MarkovChain chain = loaded(paper_chain("repair = \"scaled\"\n")).scene.chains[0];
  const std::vector<Transition>& row = chain.rows[1];
  ASSERT_EQ(row.size(), 3u);
  EXPECT_EQ(row[0].cumulative, 12162688400248056010u);  // round(2^64 * 60/91) - 1
  EXPECT_EQ(row[1].cumulative, 18244032600372084015u);  // round(2^64 * 90/91) - 1
  EXPECT_EQ(row[2].cumulative, ~std::uint64_t{0});
  EXPECT_EQ(row[2].to, 3u);
}

TEST(Markov, WhatNeverHappensIsDropped) {
  const LoadedScene got = loaded(
      "flatray = 1\n[markov.c]\nA = { A = 0, B = 1 }\nB = { A = 1e-30, B = "
      "0.999999999999999999999999999999 }\n");
  const MarkovChain& chain = got.scene.chains[0];
  ASSERT_EQ(chain.rows[0].size(), 1u);
  EXPECT_EQ(chain.rows[0][0].to, 1u);
  EXPECT_EQ(chain.rows[0][0].cumulative, ~std::uint64_t{0});
  ASSERT_EQ(chain.rows[1].size(), 1u);
  EXPECT_EQ(chain.rows[1][0].cumulative, ~std::uint64_t{0});
  ASSERT_EQ(got.warnings.size(), 1u);
  EXPECT_EQ(got.warnings[0].message, "B has steps that are never taken");
}

TEST(Markov, TheLeastStepThatCanHappenIsKept) {
  const std::vector<ChainStep> row = {{0, Rational(0x1p-64)}, {1, Rational(1) - Rational(0x1p-64)}};
  const std::vector<Transition> steps = cumulative_row(row);
  ASSERT_EQ(steps.size(), 2u);
  EXPECT_EQ(steps[0].cumulative, 0u);
  EXPECT_EQ(steps[1].cumulative, ~std::uint64_t{0});
}

TEST(Markov, MistakesAreNamed) {
  const Refused cases[] = {
      {"A = { A = 0.5, B = 0.5 }", "3:16: error: state 'B' has no row\n"},
      {"A = { A = 0.5, B = 0.5 }", "write B = { B = 1 }"},
      {"RUN = { RUM = 1 }", "3:9: error: state 'RUM' has no row (did you mean 'RUN'?)"},
      {"A = { A = 1.5 }", "3:11: error: probability A.A is 1.5"},
      {"A = { A = -0.5 }", "3:11: error: probability A.A is -0.5"},
      {"A = { A = 1.00000000000000000001 }", "probability A.A is 1.00000000000000000001"},
      {"A = { A = \"1\" }", "3:11: error: A.A is a string, not a number"},
      {"A = 1", "3:5: error: A is a number, not a table"},
      {"A = {}", "3:1: error: transitions out of A sum to 0\n"},
      {"repair = \"scaled\"\nA = {}", "add 1, or say repair = \"to-start\" or \"to-self\"\n"},
      {"A = { A = 0.6, B = 0.5 }\nB = { B = 1 }", "take 0.1 away, or say repair = \"scaled\""},
      {"repair = \"to-start\"\nA = { A = 0.6, B = 0.5 }\nB = { B = 1 }", "sum to 1.1"},
      {"repair = \"scaled\"\nA = { A = 0 }", "sum to 0\n"},
      {"repair = \"to-strat\"\nA = { A = 1 }", "(did you mean 'to-start'?)"},
      {"Run = { Run = 1 }", "3:1: error: 'Run' is not a name of a state"},
      {"hold = 0\nA = { A = 1 }", "3:8: error: markov.c.hold is 0"},
      {"hold = 2", "chain 'c' has no states"},
  };
  expect_refused(cases, [](const std::string& rows) {
    return refusal("flatray = 1\n[markov.c]\n" + rows + "\n");
  });
}

TEST(Markov, EveryBadRowIsTold) {
  const auto result =
      load("flatray = 1\n[markov.c]\nB = { B = 0.5 }\nA = { A = 0.25 }\nC = { C = 1 }\n");
  ASSERT_FALSE(result);
  ASSERT_EQ(result.error().size(), 2u);
  EXPECT_EQ(result.error()[0].message, "transitions out of B sum to 0.5");
  EXPECT_EQ(result.error()[1].message, "transitions out of A sum to 0.25");
}

}  // namespace
}  // namespace flatray
