#include "collide/minkowski.h"

#include <algorithm>

#include "geom/polygon.h"

namespace flatray {
namespace {

using Ring = std::span<const Vec2>;
using Numbers = std::vector<std::uint32_t>;

// Also: whether a -> b points into the upper half plane, or to the right along its border.
bool is_lower(const Vec2& a, const Vec2& b) {
  return a.y() < b.y() || (a.y() == b.y() && a.x() < b.x());
}

// The edges of one of the two, in the order of their angles from 0 to a full turn.
class Walk {
 public:
  // `opposite`: the ring is turned round, so that it begins at its highest vertex.
  Walk(Ring ring, bool opposite)
      : ring_(ring),
        sense_(ring_orientation(ring)),
        numbers_(turned_ring(ring, sense_)),
        opposite_(opposite) {
    const auto before = [&](std::uint32_t i, std::uint32_t k) {
      return opposite ? is_lower(ring[k], ring[i]) : is_lower(ring[i], ring[k]);
    };
    std::rotate(numbers_.begin(), std::ranges::min_element(numbers_, before), numbers_.end());
    left_ = numbers_.size() < 2 ? 0 : numbers_.size();
  }
  std::size_t size() const { return left_; }
  std::uint32_t vertex() const { return numbers_[at_]; }
  std::uint32_t next() const { return numbers_[(at_ + 1) % numbers_.size()]; }
  // The number of the edge in the ring as given.
  std::uint32_t edge() const {
    return sense_ == Sign::positive ? vertex() : sense_ == Sign::negative ? next() : 0;
  }
  // Ends of the edge as the difference has it.
  const Vec2& from() const { return ring_[opposite_ ? next() : vertex()]; }
  const Vec2& to() const { return ring_[opposite_ ? vertex() : next()]; }
  void advance() {
    at_ = (at_ + 1) % numbers_.size();
    --left_;
  }

 private:
  Ring ring_;
  Sign sense_;
  Numbers numbers_;
  bool opposite_;
  std::size_t at_ = 0, left_ = 0;
};

// Whether the edge of `a` comes no later by angle than that of `b`.
bool comes_first(const Walk& a, const Walk& b) {
  const bool up_a = is_lower(a.from(), a.to()), up_b = is_lower(b.from(), b.to());
  if (up_a != up_b) return up_a;
  return cross_sign(a.from(), a.to(), b.from(), b.to()) != Sign::negative;
}

bool spans_area(const Walk& a, const Walk& b) {
  if (a.size() > 2 || b.size() > 2) return true;
  return a.size() == 2 && b.size() == 2 &&
         cross_sign(a.from(), a.to(), b.from(), b.to()) != Sign::zero;
}

}  // namespace

Numbers turned_ring(Ring ring, Sign sense) {
  if (sense == Sign::zero) {
    const auto [low, high] = std::ranges::minmax_element(ring, is_lower);
    const auto first = static_cast<std::uint32_t>(low - ring.begin());
    const auto last = static_cast<std::uint32_t>(high - ring.begin());
    return *low == *high ? Numbers{first} : Numbers{first, last};
  }
  Numbers numbers;
  for (const std::size_t i : proper_edges(ring)) numbers.push_back(static_cast<std::uint32_t>(i));
  if (sense == Sign::negative) std::ranges::reverse(numbers);
  return numbers;
}

Difference minkowski_difference(Ring a, Ring b) {
  Walk of_a(a, false), of_b(b, true);
  Difference difference{{}, spans_area(of_a, of_b)};
  difference.corners.reserve(of_a.size() + of_b.size() + 1);
  while (of_a.size() > 0 || of_b.size() > 0) {
    const bool take_a = of_b.size() == 0 || (of_a.size() > 0 && comes_first(of_a, of_b));
    Walk& taken = take_a ? of_a : of_b;
    difference.corners.push_back(
        {of_a.vertex(), of_b.vertex(), take_a, taken.next(), taken.edge()});
    taken.advance();
  }
  if (difference.corners.empty())
    difference.corners.push_back({of_a.vertex(), of_b.vertex(), true, of_a.vertex(), 0});
  return difference;
}

}  // namespace flatray
