#pragma once
#include <span>
#include <vector>

#include "geom/ray.h"

namespace flatray {

/// Parts of one ray, closed, ascending and apart: low of each above high of the one before. One
/// point is a part.
using IntervalSet = std::vector<Range>;

/// Parts in any order, which may overlap, as a set. Parts with low > high are empty.
///
/// Error   exact for the doubles given: parts that share an end become one.
IntervalSet interval_set(std::vector<Range> parts);

/// Needs   sets, as interval_set makes them. Cost linear.
IntervalSet union_of(std::span<const Range> a, std::span<const Range> b);
IntervalSet intersection_of(std::span<const Range> a, std::span<const Range> b);
/// The closure of what is in a and not in b: the ends of what is taken out stay in, so that a
/// single point taken out changes nothing; a part that b covers goes altogether.
IntervalSet difference_of(std::span<const Range> a, std::span<const Range> b);

/// Sum of the lengths; infinite where a part is.
double length_of(std::span<const Range> set);

}  // namespace flatray
