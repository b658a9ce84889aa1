#pragma once
#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

#include "geom/exact.h"

namespace flatray {

/// A symmetric matrix, positive semidefinite, of which a row has few entries that are not 0.
class Couplings {
 public:
  explicit Couplings(std::size_t count) : rows_(count) {}

  struct Entry {
    std::size_t column;
    Rational exact;
    double about;

    template <class Number>
    const Number& value() const {
      if constexpr (std::is_same_v<Number, double>)
        return about;
      else
        return exact;
    }
  };
  const std::vector<Entry>& row(std::size_t i) const { return rows_[i]; }
  /// Needs   each column of a row once.
  void add(std::size_t row, std::size_t column, const Rational& value) {
    rows_[row].push_back({column, value, value.nearest()});
  }

 private:
  std::vector<std::vector<Entry>> rows_;
};

/// Multiplications of rationals, and unknowns to pivot, up to which an answer is exact.
inline constexpr double kMostSteps = 1 << 14;
inline constexpr std::size_t kMostPivoted = 32;

/// z >= 0 with w = M z + q >= 0, of which for each i one is 0.
struct Complementarity {
  std::vector<Rational> z, w;
};

/// Gives   such a z; of several, w is the same. nullopt where there is none.
/// Error   none up to the limits above. Beyond both z is that of doubles and depends on the order of
///         the unknowns, that there is none is not found, and of w is known only whether it is 0.
/// Cost    doubles guess which z are not 0, and one solution in rationals proves it, cheap where columns
///         that have to do with each other are near; where they are wrong some n pivots of n^2 rationals.
/// Source  block principal pivoting, Judice and Pires 1994; Lemke's method with the lexicographic rule, so
///         that it ends.
std::optional<Complementarity> solve_complementarity(const Couplings& m,
                                                     const std::vector<Rational>& q);

}  // namespace flatray
