#include "study/rooms/survival.h"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/portable_math.h"

namespace flatray {
namespace {

constexpr double kLeastTail = 100, kLeastGone = 25;  // orbits of a tail, of a stretch of it
constexpr std::size_t kLeastStretches = 3;           // to tell one law from the other
constexpr double kFreedomOfPower = 5;  // as what is left of the starts is soon like a power
constexpr double kClearly = 2;         // times what chi-squared has in one run of twenty
constexpr double kLifetimes = 5;       // after which less than one in a hundred is left
constexpr int kHalvings = 200;

// Bounces [from, to): those that are there at first, and those of them that leave.
struct Stretch {
  double from, to, there, gone;
};

// By bounces: orbits that leave then, and that are there before.
struct FallingCurve {
  std::vector<double> gone, there;

  explicit FallingCurve(std::span<const LeavingOrbit> orbits) {
    double most = 0;
    for (const LeavingOrbit& one : orbits)
      most = std::max(most, one.bounces + (one.gone ? 1.0 : 0.0));
    gone.resize(static_cast<std::size_t>(most));
    there.resize(gone.size() + 1);
    for (const LeavingOrbit& one : orbits) {
      const auto n = static_cast<std::size_t>(one.bounces);
      if (one.gone) ++gone[n];
      ++there[n];
    }
    for (std::size_t n = gone.size(); n-- > 0;) there[n] += there[n + 1];
  }

  // The tail from a start on, each stretch with enough that leave; the last one with what is left
  // over.
  std::vector<Stretch> tail(std::size_t start) const {
    std::vector<Stretch> stretches;
    for (std::size_t from = start; from < gone.size();) {
      double left = 0;
      std::size_t to = from;
      const double enough = std::max(kLeastGone, 0.1 * there[from]);
      while (to < gone.size() && left < enough) left += gone[to++];
      stretches.push_back({static_cast<double>(from), static_cast<double>(to), there[from], left});
      from = to;
    }
    return stretches;
  }
};

// The part of those at the beginning of a stretch that is there at its end is e^(-fall width),
// where the width is in bounces or in their logarithm.
struct Fit {
  double fall = 0, rest = 0;
};
Fit fit(std::span<const Stretch> stretches, double (*width)(const Stretch&)) {
  // Of the likelihood, by fall: it has one maximum.
  const auto slope = [&](double fall) {
    double sum = 0;
    for (const Stretch& one : stretches) {
      const double w = width(one), stay = portable::exp(-fall * w);
      sum += one.gone * w * stay / (1 - stay) - (one.there - one.gone) * w;
    }
    return sum;
  };
  double low = 0, high = 1;
  while (high < 0x1p60 && slope(high) > 0) high *= 2;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (slope(middle) > 0 ? low : high) = middle;
  }
  Fit found{0.5 * (low + high), 0};
  for (const Stretch& one : stretches) {
    const double stay = portable::exp(-found.fall * width(one));
    const double off = one.gone - one.there * (1 - stay);
    found.rest += off * off / (one.there * stay * (1 - stay));
  }
  return found;
}

double in_bounces(const Stretch& one) { return one.to - one.from; }
double in_logarithms(const Stretch& one) { return portable::log((one.to + 1) / (one.from + 1)); }

Survival looked_at(const FallingCurve& curve, std::size_t start, double design_effect) {
  Survival found;
  found.start = static_cast<double>(start);
  const std::vector<Stretch> tail = curve.tail(start);
  if (tail.size() < kLeastStretches) return found;
  const Fit rate = fit(tail, &in_bounces), power = fit(tail, &in_logarithms);
  found.rate = rate.fall;
  found.power = power.fall;
  found.rate_rest = rate.rest / design_effect;
  found.power_rest = power.rest / design_effect;
  found.freedom = static_cast<double>(tail.size() - 1);
  const double most = chi_squared_95(found.freedom);
  found.last = static_cast<double>(curve.gone.size()) - 1;
  found.left_then = curve.there[start] * portable::exp(-found.rate * (found.last - found.start));
  const bool fits = found.rate_rest <= most;
  if (fits && !found.outlasted() && found.power_rest > kClearly * most)
    found.law = Survival::Law::exponential;
  if (!fits && found.power_rest <= most && found.freedom >= kFreedomOfPower)
    found.law = Survival::Law::power;
  return found;
}

// Whether a later start is clearly not of the law of the first.
bool contradicts(const Survival& later, Survival::Law first) {
  using Law = Survival::Law;
  const double rest = first == Law::exponential ? later.rate_rest : later.power_rest;
  if (first == Law::exponential && later.outlasted()) return true;
  return first != Law::undecided && rest > kClearly * chi_squared_95(later.freedom);
}

// Of those that are there before each bounce from a start on, the sums of those that leave.
StartSums leaving_from(double start, std::span<const LeavingOrbit> orbits, Starts starts) {
  StartSums leaving(starts);
  for (std::size_t i = 0; i < orbits.size(); ++i)
    if (const auto& [bounces, length, gone] = orbits[i]; bounces >= start)
      leaving.add(i, gone ? 1 : 0, bounces - start + (gone ? 1 : 0));
  return leaving;
}

// By how much more the variance of what leaves is than that of independent orbits.
double design_effect(std::span<const LeavingOrbit> orbits, Starts starts) {
  if (starts != Starts::conditional) return 1;
  const double together = leaving_from(0, orbits, starts).all().standard_error(),
               apart = leaving_from(0, orbits, Starts::random).all().standard_error();
  return apart > 0 ? std::max(1.0, together * together / (apart * apart)) : 1;
}

// Mean of a number of bounces below `most` that falls like e^(-rate n).
double mean_bounces(double rate, double most) {
  const double all = 1 / (portable::exp(rate) - 1);
  return rate * most > 700 ? all : all - most / (portable::exp(rate * most) - 1);
}

// The rate by length is the root of the sum of these: an orbit's weight e^(rate length), times how
// much more often it bounces than orbits do in the mean. Times e^(-decay bounces), which does not
// move the root, all weights are about as large.
struct Weighted {
  std::size_t sample;
  double length, decay, excess;
  double at(double rate) const { return excess * portable::exp(rate * length - decay); }
};

Measure by_length(std::span<const LeavingOrbit> orbits, double start, double rate, double limit,
                  Starts starts) {
  // Some few that stay much longer, on long ways, would weigh as much as all others.
  const double end = std::min(limit, start + std::ceil(kLifetimes / rate) + 1);
  const double mean = mean_bounces(rate, end - start);
  const auto counts = [&](const LeavingOrbit& one) {
    return one.gone && one.bounces >= start && one.bounces < end;
  };
  double shortest = kInfinity;
  for (const LeavingOrbit& one : orbits)
    if (counts(one)) shortest = std::min(shortest, one.length);
  std::vector<Weighted> terms;
  const std::size_t samples = starts == Starts::random ? orbits.size() : kShifts;
  for (std::size_t i = 0; i < orbits.size(); ++i)
    if (const LeavingOrbit& one = orbits[i]; counts(one))
      terms.push_back({i % samples, one.length - shortest, rate * (one.bounces - start),
                       one.bounces - start - mean});
  double longest = 0;
  for (const Weighted& one : terms) longest = std::max(longest, one.length);
  const auto total = [&](double at) {
    double sum = 0;
    for (const Weighted& one : terms) sum += one.at(at);
    return sum;
  };
  Measure measure{"escape_rate_per_length", rate_of_zero(total, longest)};
  std::vector<double> parts(samples);
  double squares = 0, slope = 0;
  for (const Weighted& one : terms) {
    const double term = one.at(measure.value);
    parts[one.sample] += term;
    slope += one.length * term;
  }
  for (const double part : parts) squares += part * part;
  if (starts != Starts::random) squares *= kShifts / (kShifts - 1.0);
  measure.standard_error = std::sqrt(squares) / std::fabs(slope);
  return measure;
}

}  // namespace

Survival survival(std::span<const LeavingOrbit> orbits, Starts starts) {
  using Law = Survival::Law;
  const FallingCurve curve(orbits);
  const double more = design_effect(orbits, starts);
  Survival first, last;
  for (std::size_t start = starts == Starts::conditional ? 0 : 1, step = 1;
       start < curve.gone.size(); start += step) {
    if (curve.there[start] < kLeastTail) break;
    const Survival found = looked_at(curve, start, more);
    if (found.freedom == 0) break;
    last = found;
    last.law = Law::undecided;
    if (found.law != Law::undecided && first.law == Law::undecided) first = found;
    if (contradicts(found, first.law)) return last;
    step = std::max<std::size_t>(1, std::bit_floor(start) >> 1);
  }
  return first.law == Law::undecided ? last : first;
}

double rate_of_zero(const std::function<double(double)>& sum, double longest) {
  double low = 0, high = 0x1p-10 / longest;
  while (high * longest < 600 && sum(high) < 0) high *= 2;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (sum(middle) < 0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// What is left of the beginning falls from bounce to bounce; at the start it is as large as chance.
std::optional<double> late_start(const Survival& found) {
  if (found.law != Survival::Law::exponential) return std::nullopt;
  return 2 * found.start;
}

std::vector<Measure> escape_rates(std::span<const LeavingOrbit> orbits, const Survival& found,
                                  std::uint64_t limit, Starts starts, double memory) {
  const double start = *late_start(found);
  double last = 0, there = 0;
  for (const LeavingOrbit& one : orbits) {
    last = std::max(last, one.bounces);
    if (one.bounces >= start) ++there;
  }
  const RatioSums leaving = leaving_from(start, orbits, starts).all();
  if (leaving.x < kLeastGone || leaving.x == leaving.y) return {};
  const double stay = 1 - leaving.ratio(), rate = -portable::log(stay);
  Measure by_bounce{"escape_rate_per_bounce", rate, leaving.standard_error() / stay};
  Measure by_way =
      by_length(orbits, std::max(start, memory), rate, static_cast<double>(limit), starts);
  for (Measure* one : {&by_bounce, &by_way}) {
    one->freedom = std::min(leaving.x, leaving.samples) - 1;
    one->remark = fmt::format("of {:.0f} orbits from bounce {:.0f} to {:.0f}", there, start, last);
  }
  if (!std::isfinite(*by_way.standard_error)) return {std::move(by_bounce)};
  return {std::move(by_bounce), std::move(by_way)};
}

}  // namespace flatray
