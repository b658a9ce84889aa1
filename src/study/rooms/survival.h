#pragma once
#include <functional>

#include "study/rooms/starts.h"

namespace flatray {

/// What becomes of an orbit in an open room: how often it bounces, how long its way is up to the
/// last bounce, and whether it is gone then, or was given up.
struct LeavingOrbit {
  double bounces, length;
  bool gone;
};

/// How the number of those that are still there after n bounces falls.
struct Survival {
  enum class Law : std::uint8_t {
    exponential,  ///< like e^(-rate n), and not like a power
    power,        ///< like (n + 1)^-power, and not exponentially
    undecided     ///< like both, as far as the data tell, or like neither
  } law = Law::undecided;
  double start = 0;            ///< bounces from which on that is so, or was looked at last
  double rate = 0, power = 0;  ///< of the two fits from `start` on
  /// Squares of what either leaves, in variances; under 1 a degree of freedom where it fits.
  double rate_rest = 0, power_rest = 0;
  double freedom = 0;            ///< of either; 0 where there are too few orbits for fits at all
  double last = 0;               ///< bounces after which the last orbit of all is gone or given up
  double left_then = kInfinity;  ///< orbits that the rate has left then

  /// Whether these are too few for one to be there: no rate, whatever the rest.
  bool outlasted() const { return left_then < 1e-3; }
};

/// Both laws are fitted to the tail from 1, 2, 3, 4, 6, 8, 12, ... bounces on, as long as a hundred
/// orbits are left, and tested by chi-squared in stretches of 25 and more. The first start from
/// which one of them fits decides, unless a later one is clearly not of it. No rate fits that has less
/// than a thousandth of an orbit left when the last one is gone: squares hardly see it. What falls like a power
/// is soon like an exponential for a few orbits: that is decided only where a power leaves twice
/// what it may. What falls exponentially is like a power until its starts are forgotten: that is
/// decided only of six stretches and more.
///
/// Of conditional starts from 0 bounces on, squares divided by how much more their groups differ
/// than independent orbits would (the design effect: Rao and Scott 1981).
///
/// Needs   orbits in the order of their starts, independent of each other but for what `starts`
///         says.
Survival survival(std::span<const LeavingOrbit> orbits, Starts starts = Starts::random);

/// The rate, by halves, at which a sum that rises from below 0 is 0: of terms that grow like
/// e^(rate length), of lengths up to `longest`.
double rate_of_zero(const std::function<double(double)>& sum, double longest);
/// From how many bounces on what is left of the beginning is small beside chance; none where the
/// law is not exponential.
std::optional<double> late_start(const Survival& found);

/// Rates of an exponential decay by bounce and by length, with errors, from a start so late that
/// what is left of the beginning is small beside them. By length it is where the sum of e^(rate
/// length) over those that leave at bounce n depends on n no more: how lengths are spread then does
/// not matter, as it does where they are counted as if they were a time.
///
/// Needs   survival(orbits, starts).law is exponential; `limit` bounces after which orbits were
///         given up. That by length is from `memory` bounces on or later: what is invariant by
///         bounces is not by length.
/// Gives   none where too few are left, that by length none where none is left from there on.
std::vector<Measure> escape_rates(std::span<const LeavingOrbit> orbits, const Survival& found,
                                  std::uint64_t limit, Starts starts = Starts::random,
                                  double memory = 0);

}  // namespace flatray
