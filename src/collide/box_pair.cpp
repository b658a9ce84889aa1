#include "collide/box_pair.h"

#include <algorithm>
#include <iterator>

namespace flatray {
namespace {

const Vec2 kUpright[] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};

std::vector<Vec2> corners(const Bounds& box) {
  return {box.low, {box.high.x(), box.low.y()}, box.high, {box.low.x(), box.high.y()}};
}

}  // namespace

BoxPair::BoxPair(std::span<const TurningBody> a, std::span<const TurningBody> b, double length,
                 bool backwards) {
  for (const TurningBody& one : a)
    for (const TurningBody& other : b) pairs_.emplace_back(one, other, length, backwards);
}

double BoxPair::apart_for(double) const {
  double best = 0;
  for (const Vec2& normal : kUpright) {
    double least = kInfinity;
    for (const TurningPair& pair : pairs_)
      if (least > best) least = std::min(least, pair.apart_along(normal));
    best = std::max(best, least);
  }
  return best;
}

double BoxPair::overlap_for() const {
  double least = kInfinity;
  for (const Vec2& normal : kUpright) {
    double longest = 0;
    for (const TurningPair& pair : pairs_) longest = std::max(longest, pair.overlap_along(normal));
    least = std::min(least, longest);
  }
  return least;
}

ContactPlace BoxPair::touching_place() const {
  Bounds a, b;
  for (const TurningPair& pair : pairs_) a.add(pair.box_a()), b.add(pair.box_b());
  const std::vector<Vec2> one = corners(a), other = corners(b);
  return resting_place({one, {0, 0}}, {other, {0, 0}}, 0);
}

}  // namespace flatray
