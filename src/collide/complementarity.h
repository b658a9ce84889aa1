#pragma once
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "geom/exact.h"

namespace flatray {

/// A symmetric matrix, positive semidefinite: of each row the entries that are not 0, column and value, each
/// column once.
template <class Number>
using Couplings = std::vector<std::vector<std::pair<std::size_t, Number>>>;

/// z >= 0 with w = M z + q >= 0, of which for each i one is 0.
template <class Number>
struct Complementarity {
  std::vector<Number> z;
  std::vector<bool> touches;  ///< w is 0
  bool holds = true;          ///< false: as far as doubles tell, it is no such z
  bool refused = false;       ///< it would take more than kMostGuess: there is nothing else
};

inline double nearest(double x) { return x; }
inline double nearest(const Rational& x) { return x.nearest(); }

/// Unknowns up to which pivots of rationals end in seconds.
inline constexpr std::size_t kMostPivoted = 32;

/// Products up to which doubles look for the z that are not 0: a second. Hundreds of unknowns that all hang
/// together take more, where guesses do not come nearer.
inline constexpr double kMostGuess = 1 << 30;

/// Gives   such a z; of several, w is the same. nullopt where there is none.
/// Error   none.
/// Cost    doubles guess which z are not 0, and one solution in rationals proves it; where they are wrong
///         some n pivots of n^2 rationals, of which the numbers grow.
/// Source  block principal pivoting, Judice and Pires 1994; Lemke's method with the lexicographic rule, so
///         that it ends.
std::optional<Complementarity<Rational>> solve_complementarity(const Couplings<Rational>& m,
                                                               const std::vector<Rational>& q);
/// The guess alone, refused beyond kMostGuess. nullopt where it is known to be wrong and the unknowns are few enough
/// for rationals.
/// Error   that of doubles; which of several z depends on the order of the unknowns.
/// Cost    linear where columns that have to do with each other are near, some factorings.
std::optional<Complementarity<double>> solve_complementarity(const Couplings<double>& m,
                                                             const std::vector<double>& q);

/// How many words are multiplied with words for a proof in rationals, about, of entries of so many bits.
double work_of_proof(const Couplings<double>& m, double bits);

}  // namespace flatray
