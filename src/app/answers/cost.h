#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace flatray {

/// What a piece of work took of the calling thread, once.
struct Cost {
  double seconds = 0;                  ///< of processor time
  std::optional<double> instructions;  ///< where the machine counts them
};

Cost cost_of(const std::function<void()>& work);

/// How often a round can be repeated in about a second if it takes so many: often enough for
/// kConfidence, and no more than is of use.
std::size_t rounds_for(double seconds_a_round);

/// The confidence of the intervals below, each of a median of rounds (study/statistics/median.h).
inline constexpr double kConfidence = 0.99;

/// Costs of the same work in rounds, in one unit.
struct CostRounds {
  std::vector<double> values;
  bool instructions = false;  ///< else seconds
};

/// In instructions where every round of every work has them, in seconds else.
std::vector<CostRounds> in_one_unit(const std::vector<std::vector<Cost>>& works);

/// "10.6 ms a frame (10.4 to 10.9)": the median of the rounds, and the interval that holds it.
std::string amount_words(const CostRounds& rounds, std::size_t frames);

/// "25 % (24 to 26)": the median of what each round of `without` takes less than that of `with`,
/// and its interval; "costs 4 % (3 to 5)" where it takes more; "not measurable" where the interval
/// includes no change.
///
/// Needs   rounds of both in turns, as many of one as of the other.
std::string saving_words(const CostRounds& without, const CostRounds& with);

}  // namespace flatray
