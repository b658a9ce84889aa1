#pragma once

namespace flatray {

/// Cosine and sine of an angle in radians.
///
/// Gives   quarter turns exactly: for angles within 1 ulp of k * pi/2, which is what sums and
///         products of rounded radians leave of them.
struct Turn {
  double cos = 1, sin = 0;
};
Turn turn(double angle);

}  // namespace flatray
