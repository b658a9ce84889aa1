#include "study/periodic/cycle_expansion.h"

#include <Eigen/Core>
#include <cmath>
#include <optional>

#include "base/portable_math.h"

namespace flatray {
namespace {

enum { of_bounces, of_lengths, of_stretches };

// The determinant cut off after `most` bounces, and its derivatives by the rates of bounces, of
// lengths and of logarithms of eigenvalues.
struct Determinant {
  double value = 1;
  Eigen::Array3d by{0, 0, 0};
};

// Terms by number of bounces, of which the determinant is exp(-sum): what multiplies one rate is
// its derivative, too.
Determinant determinant(const std::vector<Cycle>& cycles, std::size_t most, double per_length,
                        double per_bounce) {
  std::vector<Determinant> terms(most + 1, {0}), parts(most + 1, {0});
  for (const Cycle& cycle : cycles) {
    double power = 1;
    const double stretch = portable::log(std::fabs(cycle.eigenvalue));
    for (std::size_t r = 1; r * cycle.bounces <= most; ++r) {
      power *= cycle.eigenvalue;
      const double times = static_cast<double>(r), bounces = static_cast<double>(cycle.bounces);
      const double grown =
          portable::exp(times * (per_length * cycle.length + per_bounce * bounces));
      const double weight = grown / std::fabs((1 - power) * (1 - 1 / power));
      Determinant& term = terms[r * cycle.bounces];
      term.value += weight / times;
      term.by += weight * Eigen::Array3d(bounces, cycle.length, stretch);
    }
  }
  parts[0] = {};
  Determinant sum;
  for (std::size_t n = 1; n <= most; ++n) {
    Determinant& part = parts[n];
    for (std::size_t k = 1; k <= n; ++k) {
      const double share = -static_cast<double>(k) / static_cast<double>(n);
      const Determinant &term = terms[k], &rest = parts[n - k];
      part.value += share * term.value * rest.value;
      part.by += share * (term.by * rest.value + term.value * rest.by);
    }
    sum.value += part.value;
    sum.by += part.by;
  }
  return sum;
}

// The least rate above 0 at which a determinant is 0, by steps of `step`, then by halves.
template <class Of>
std::optional<double> zero(const Of& of, double step) {
  constexpr int kMostSteps = 1000, kHalvings = 100;
  double low = 0, high = step;
  if (!(of(low) > 0)) return std::nullopt;
  for (int i = 0; of(high) > 0; ++i, low = high, high += step)
    if (i == kMostSteps) return std::nullopt;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = low + (high - low) / 2;
    (of(middle) > 0 ? low : high) = middle;
  }
  return low;
}

}  // namespace

std::vector<CycleMeans> cycle_means(const std::vector<Cycle>& cycles, std::size_t most) {
  constexpr double kStep = 1.0 / 32;  // a bounce
  double bounces = 0, length = 0;
  for (const Cycle& cycle : cycles) {
    bounces += static_cast<double>(cycle.bounces);
    length += cycle.length;
  }
  std::vector<CycleMeans> all;
  for (std::size_t n = 1; n <= most; ++n) {
    const auto per_length = zero([&](double rate) { return determinant(cycles, n, rate, 0).value; },
                                 kStep * bounces / length);
    const auto per_bounce =
        zero([&](double rate) { return determinant(cycles, n, 0, rate).value; }, kStep);
    if (!per_length || !per_bounce) continue;
    const Determinant at = determinant(cycles, n, *per_length, 0);
    all.push_back({n, *per_length, *per_bounce, at.by[of_lengths] / at.by[of_bounces],
                   at.by[of_stretches] / at.by[of_lengths]});
  }
  return all;
}

}  // namespace flatray
