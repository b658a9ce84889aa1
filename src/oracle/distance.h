#pragma once
#include <optional>
#include <vector>

#include "geom/pair.h"

namespace flatray::oracle {

template <class Number>
using RingOf = std::vector<Pair<Number>>;

/// From the nearest of some points to the sides of a ring.
template <class Number>
Number squared_distance(const RingOf<Number>& points, const RingOf<Number>& ring) {
  std::optional<Number> least;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Pair<Number> along = ring[(i + 1) % ring.size()] - ring[i];
    const Number length = dot(along, along);
    for (const Pair<Number>& p : points) {
      const Pair<Number> from = p - ring[i];
      const Number ahead = dot(from, along), across = cross(from, along);
      const Pair<Number> rest = ahead > 0 ? from - along : from;
      const bool beside = ahead > 0 && ahead < length;
      const Number squared = beside ? Number(across * across / length) : dot(rest, rest);
      if (!least || squared < *least) least = squared;
    }
  }
  return *least;
}

/// Between two rings that do not cross.
template <class Number>
Number squared_gap(const RingOf<Number>& a, const RingOf<Number>& b) {
  const Number one = squared_distance(a, b), other = squared_distance(b, a);
  return one < other ? one : other;
}

}  // namespace flatray::oracle
