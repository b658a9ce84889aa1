#pragma once
#include <cstddef>
#include <vector>

namespace flatray {

/// A periodic orbit of an open room, as its mean counts it.
struct Cycle {
  std::size_t bounces;
  double length, eigenvalue;  ///< of the larger size, with its sign
};

/// What the orbits of up to so many bounces give for those that stay in an open room for ever.
struct CycleMeans {
  std::size_t bounces;
  double escape_rate;         ///< a unit of length
  double escape_rate_bounce;  ///< a bounce
  double flight;              ///< mean length between bounces, by the natural measure
  double lyapunov;            ///< a unit of length
};

/// The leading zero of the spectral determinant det = exp(-sum over p, r of e^(g r L_p) / (r |(1 -
/// E_p^r) (1 - E_p^-r)|)), expanded by the number of bounces and cut off after each; and
/// derivatives of it.
///
/// Needs   all orbits of up to `most` bounces that repeat none, all unstable.
/// Gives   from the first number of bounces on that gives a zero. Where words are as free as those
///         of discs far apart it converges faster than exponentially; what is left out is not
///         bounded here.
/// Source  P. Cvitanovic et al., Chaos: Classical and Quantum, chapters "Trace formulas", "Cycle
///         expansions"; of three discs P. Gaspard and S. Rice, J. Chem. Phys. 90 (1989) 2225.
std::vector<CycleMeans> cycle_means(const std::vector<Cycle>& cycles, std::size_t most);

}  // namespace flatray
