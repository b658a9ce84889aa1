#pragma once
#include "geom/exact.h"
#include "scene/scene.h"

// Markov chains by their fractions, with the table of draws the scene module would make.
namespace flatray::testing {

/// "3/5" or "1". Needs digits that an int holds.
inline Rational rational(const std::string& text) {
  const std::size_t bar = text.find('/');
  const Rational above(std::stoi(text.substr(0, bar)));
  return bar == std::string::npos ? above : above / Rational(std::stoi(text.substr(bar + 1)));
}

/// round(2^64 * p) - 1 for p in (0, 1].
inline std::uint64_t table_entry(const Rational& p) {
  const Rational scaled = (p * Rational(0x1p64) + Rational(0.5)).floor() - Rational(1);
  const Rational high = (scaled / Rational(0x1p32)).floor();
  const Rational low = scaled - high * Rational(0x1p32);
  return (static_cast<std::uint64_t>(high.nearest()) << 32) |
         static_cast<std::uint64_t>(low.nearest());
}

inline MarkovChain chain_of(std::string name, std::vector<std::string> states,
                            std::vector<std::vector<std::string>> fractions) {
  MarkovChain chain;
  chain.name = std::move(name);
  chain.states = std::move(states);
  for (const std::vector<std::string>& row : fractions) {
    Rational sum;
    chain.rows.emplace_back();
    chain.probabilities.emplace_back();
    for (StateId to = 0; to < row.size(); ++to) {
      const Rational p = rational(row[to]);
      sum += p;
      chain.probabilities.back().push_back(p.nearest());
      if (p.sign() == Sign::positive) chain.rows.back().push_back({table_entry(sum), to});
    }
  }
  chain.fractions = std::move(fractions);
  return chain;
}

/// The paper's chain with RUNNING repaired in its three ways (facts, section 8).
inline std::vector<MarkovChain> paper_chains() {
  const std::vector<std::string> states = {"STANDING", "RUNNING", "JUMP", "DIE"};
  const auto repaired = [&](const char* name, std::vector<std::string> running) {
    return chain_of(name, states,
                    {{"1/10", "17/20", "0", "1/20"},
                     std::move(running),
                     {"0", "0", "1/4", "3/4"},
                     {"0", "0", "0", "1"}});
  };
  return {repaired("to_start", {"9/100", "3/5", "3/10", "1/100"}),
          repaired("to_self", {"0", "69/100", "3/10", "1/100"}),
          repaired("scaled", {"0", "60/91", "30/91", "1/91"})};
}

}  // namespace flatray::testing
