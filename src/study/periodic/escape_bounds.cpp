#include "study/periodic/escape_bounds.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "study/periodic/disc_words.h"
#include "study/periodic/numbered_words.h"
#include "study/statistics/blocks.h"

namespace flatray {
namespace {

constexpr std::size_t kFewestBounces = 6;

// What a word multiplies numbers of orbits with, by length and by bounces, and by what part it may
// be off.
struct WordWeight {
  double by_length = 0, by_bounce = 0;
  float off = 0;
};

class TransferMatrix {
 public:
  TransferMatrix(const ExperimentContext& context, const OpenDiscs& discs, std::size_t bounces,
                 double rate)
      : context_(context), words_(discs.size(), bounces), weights_(words_.size()), rate_(rate) {
    std::vector<Range> lengths((words_.size() + kBlock - 1) / kBlock, {kInfinity, 0});
    const auto ran = run_tasks(context, lengths.size(), [&](std::size_t block) {
      const std::size_t end = std::min(words_.size(), (block + 1) * kBlock);
      for (std::size_t i = block * kBlock; i < end; ++i)
        weights_[i] = weight(middle_step(discs, words_[i]), lengths[block]);
    });
    for (const Range& one : lengths)
      length_ = {std::min(length_.low, one.low), std::max(length_.high, one.high)};
    tell_enough_ = ran && std::ranges::all_of(weights_, [](const WordWeight& one) {
                     return one.off < 1 && one.by_length > 0 && std::isfinite(one.by_length);
                   });
  }

  // Of the rate at which what is multiplied by e^(rate length) and divided by stretches neither
  // grows nor falls.
  Range per_length() const {
    const Range growth = logarithm(&WordWeight::by_length);
    const auto steps = [&](double of, bool up) {
      const double a = of / length_.low, b = of / length_.high;
      return up ? std::max(a, b) : std::min(a, b);
    };
    return {rate_ - steps(growth.high, true), rate_ - steps(growth.low, false)};
  }
  Range per_bounce() const {
    const Range growth = logarithm(&WordWeight::by_bounce);
    return {-growth.high, -growth.low};
  }

 private:
  static constexpr std::size_t kBlock = 256;
  static constexpr double kMore = 1 + 1e-6;     // for rounding to float, and of the bound itself
  static constexpr double kRounding = 0x1p-44;  // of at most 64 terms and what each is made of

  WordWeight weight(const OrbitStep& step, Range& lengths) const {
    const auto& [length, stretch] = step;
    lengths = {std::min(lengths.low, length.low()), std::max(lengths.high, length.high())};
    const bool known = length.low() > 0 && stretch.low() > 0;
    const double off =
        known ? std::fabs(rate_) * length.error() + stretch.error() / stretch.low() : kInfinity;
    return {portable::exp(rate_ * length.value()) / stretch.value(), 1 / stretch.value(),
            static_cast<float>(off * (1 + off) * kMore + kRounding)};
  }

  Range logarithm(double WordWeight::*of) const {
    if (!tell_enough_) return kLine;
    return {portable::log(eigenvalue(of, -1).low) - kRounding,
            portable::log(eigenvalue(of, 1).high) + kRounding};
  }

  // Of the matrix of lower or upper bounds, the largest: for any positive vector it is between the
  // least and the most of what the matrix multiplies its numbers with. Source: L. Collatz (1942),
  // H. Wielandt (1950).
  Range eigenvalue(double WordWeight::*of, double side) const {
    constexpr int kMostRounds = 400;
    constexpr double kAlike = 1e-14;
    std::vector<double> vector(words_.starts(), 1), next(vector.size());
    Range bounds{0, kInfinity};
    for (int round = 0; round < kMostRounds && !context_.stopped(); ++round) {
      Range ratio{kInfinity, 0};
      for (std::size_t i = 0; i < vector.size(); ++i) {
        next[i] = 0;
        for (std::size_t k = i * words_.ways_on(); k < (i + 1) * words_.ways_on(); ++k)
          next[i] += weights_[k].*of * (1 + side * static_cast<double>(weights_[k].off)) *
                     vector[words_.end_of(k)];
        const double one = next[i] / vector[i];
        ratio = {std::min(ratio.low, one), std::max(ratio.high, one)};
      }
      bounds = {std::max(bounds.low, ratio.low), std::min(bounds.high, ratio.high)};
      if (ratio.high - ratio.low < kAlike * ratio.high) break;
      // Half of what it was stays, so that rooms of two discs, where it goes to and fro, come to
      // rest.
      for (std::size_t i = 0; i < vector.size(); ++i)
        vector[i] = (vector[i] + next[i] / ratio.high) / 2;
    }
    return bounds;
  }

  const ExperimentContext& context_;
  NumberedWords words_;
  std::vector<WordWeight> weights_;
  double rate_;
  Range length_{kInfinity, 0};
  bool tell_enough_;
};

}  // namespace

tl::expected<EscapeBounds, std::string> escape_bounds(const ExperimentContext& context,
                                                      const MirrorRoom& room,
                                                      std::size_t most_words, double about) {
  const std::size_t bounces = NumberedWords::most_bounces(room.mirrors.size(), most_words);
  if (bounces < kFewestBounces)
    return tl::unexpected(
        fmt::format("there are more than {} words of {} bounces", most_words, kFewestBounces));
  const auto discs = OpenDiscs::of(room);
  if (!discs) return tl::unexpected(discs.error());
  const TransferMatrix transfer(context, *discs, bounces, about);
  const EscapeBounds made{bounces, transfer.per_length(), transfer.per_bounce()};
  if (context.stopped()) return tl::unexpected(std::string("stopped"));
  if (!std::isfinite(made.per_length.high - made.per_length.low) ||
      made.per_length.low > made.per_length.high || made.per_bounce.low > made.per_bounce.high)
    return tl::unexpected(fmt::format("words of {} bounces tell too little", bounces));
  return made;
}

}  // namespace flatray
