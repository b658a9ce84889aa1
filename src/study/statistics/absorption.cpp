#include "study/statistics/absorption.h"

#include <algorithm>
#include <string_view>

namespace flatray {
namespace {

Rational rational_of(std::uint64_t number) {
  const auto high = static_cast<double>(number >> 32),
             low = static_cast<double>(number & 0xffffffff);
  return Rational(high) * Rational(0x1p32) + Rational(low);
}

std::optional<Rational> whole_number(std::string_view digits) {
  if (digits.empty()) return std::nullopt;
  Rational value;
  for (const char c : digits) {
    if (c < '0' || c > '9') return std::nullopt;
    value = value * Rational(10) + Rational(c - '0');
  }
  return value;
}

// "3/5", "1" or "0".
std::optional<Rational> fraction(std::string_view text) {
  const std::size_t bar = text.find('/');
  const std::optional<Rational> above = whole_number(text.substr(0, bar));
  if (bar == std::string_view::npos) return above;
  const std::optional<Rational> below = whole_number(text.substr(bar + 1));
  if (!above || !below || below->sign() == Sign::zero) return std::nullopt;
  return *above / *below;
}

// The first convergent of the continued fraction of `value` >= 0 that rounds to it.
Rational simplest_fraction(double value) {
  Rational rest(value), above(1), below(0), above_before(0), below_before(1);
  for (;;) {
    const Rational whole = rest.floor();
    above_before = std::exchange(above, whole * above + above_before);
    below_before = std::exchange(below, whole * below + below_before);
    if ((above / below).nearest() == value) return above / below;
    rest = Rational(1) / (rest - whole);
  }
}

bool sums_to_one(const std::vector<Rational>& row) {
  Rational sum;
  for (const Rational& probability : row) sum += probability;
  return sum == Rational(1);
}

// States from which a state marked in `goals` can be reached, themselves included.
std::vector<bool> reaching(const StepMatrix& steps, std::vector<bool> goals) {
  for (bool grown = true; grown;) {
    grown = false;
    for (std::size_t i = 0; i < steps.size(); ++i)
      for (std::size_t j = 0; j < steps.size() && !goals[i]; ++j)
        if (goals[j] && steps[i][j].sign() != Sign::zero) goals[i] = grown = true;
  }
  return goals;
}

// Solves matrix * x = right by elimination. Needs the matrix to be regular.
std::vector<Rational> solve(StepMatrix matrix, std::vector<Rational> right) {
  const std::size_t n = matrix.size();
  for (std::size_t pivot = 0; pivot < n; ++pivot) {
    std::size_t row = pivot;
    while (matrix[row][pivot].sign() == Sign::zero) ++row;
    std::swap(matrix[row], matrix[pivot]);
    std::swap(right[row], right[pivot]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == pivot || matrix[i][pivot].sign() == Sign::zero) continue;
      const Rational factor = matrix[i][pivot] / matrix[pivot][pivot];
      for (std::size_t j = pivot; j < n; ++j)
        if (matrix[pivot][j].sign() != Sign::zero) matrix[i][j] -= factor * matrix[pivot][j];
      right[i] -= factor * right[pivot];
    }
  }
  for (std::size_t i = 0; i < n; ++i) right[i] /= matrix[i][i];
  return right;
}

// I - Q of the states listed.
StepMatrix left_over(const StepMatrix& steps, const std::vector<std::size_t>& states) {
  StepMatrix matrix(states.size(), std::vector<Rational>(states.size()));
  for (std::size_t i = 0; i < states.size(); ++i)
    for (std::size_t j = 0; j < states.size(); ++j)
      matrix[i][j] = Rational(i == j ? 1 : 0) - steps[states[i]][states[j]];
  return matrix;
}

}  // namespace

StepMatrix drawn_probabilities(const MarkovChain& chain) {
  StepMatrix steps(chain.rows.size(), std::vector<Rational>(chain.rows.size()));
  for (std::size_t i = 0; i < chain.rows.size(); ++i) {
    Rational below;  // draws that took an earlier choice
    for (const Transition& choice : chain.rows[i]) {
      const Rational up_to = rational_of(choice.cumulative) + Rational(1);
      steps[i][choice.to] += (up_to - below) / Rational(0x1p64);
      below = up_to;
    }
  }
  return steps;
}

std::optional<StepMatrix> given_probabilities(const MarkovChain& chain) {
  StepMatrix steps;
  for (const std::vector<std::string>& row : chain.fractions) {
    steps.emplace_back();
    for (const std::string& text : row) {
      const std::optional<Rational> probability = fraction(text);
      if (!probability) return std::nullopt;
      steps.back().push_back(*probability);
    }
  }
  if (chain.fractions.empty())
    for (const std::vector<double>& row : chain.probabilities) {
      steps.emplace_back();
      for (const double probability : row) steps.back().push_back(simplest_fraction(probability));
    }
  const bool whole = steps.size() == chain.rows.size() && std::ranges::all_of(steps, sums_to_one);
  return whole ? std::optional(std::move(steps)) : std::nullopt;
}

std::vector<bool> absorbing_states(const StepMatrix& steps) {
  std::vector<bool> absorbing;
  for (std::size_t i = 0; i < steps.size(); ++i) absorbing.push_back(steps[i][i] == Rational(1));
  return absorbing;
}

std::vector<std::optional<Absorption>> steps_to_absorption(const StepMatrix& steps,
                                                           const std::vector<bool>& absorbing) {
  std::vector<bool> hopeless = reaching(steps, absorbing);
  hopeless.flip();
  const std::vector<bool> uncertain = reaching(steps, hopeless);
  std::vector<std::size_t> states;  // that are left with certainty
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (!absorbing[i] && !uncertain[i]) states.push_back(i);

  const StepMatrix matrix = left_over(steps, states);
  const std::vector<Rational> mean =
      solve(matrix, std::vector<Rational>(states.size(), Rational(1)));
  std::vector<Rational> right;  // of the second moment m: (I - Q) m = 1 + 2 Q n = 2 n - 1
  for (const Rational& n : mean) right.push_back(Rational(2) * n - Rational(1));
  const std::vector<Rational> square = solve(matrix, right);

  std::vector<std::optional<Absorption>> found(steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (absorbing[i]) found[i] = Absorption{};
  for (std::size_t k = 0; k < states.size(); ++k)
    found[states[k]] = Absorption{mean[k], square[k] - mean[k] * mean[k]};
  return found;
}

}  // namespace flatray
