#include "collide/certain_contact.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "geom/hit_time.h"

namespace flatray {
namespace {

using Ready = PolygonSet::Ready;

// A determinant, and more than it can be off by (geom/error_bounds.h).
struct Estimate {
  double value, error;

  Estimate(const Vec2& a, const Vec2& b) {
    const double left = a.x() * b.y(), right = a.y() * b.x();
    value = left - right;
    error = kDetFilter * (std::fabs(left) + std::fabs(right)) + kDetFilterLeast;
  }
  bool is_certain() const { return std::fabs(value) > error; }
};

enum class When { unsure, before, within, after };

// An edge of one shape and the vertex of the other that it meets.
struct Meeting {
  const Vec2 *from, *to, *vertex;
  Vec2 velocity_edge, velocity_vertex;
  ContactFeature feature;

  RoundedTime time() const {
    return HitTime::on_moving_line({*vertex, velocity_vertex}, *from, *from, *to, velocity_edge)
        .nearest();
  }

  // Its time against 0 and `length`.
  When when(double length) const {
    const Vec2 along = *to - *from;
    const Estimate numer(*from - *vertex, along), denom(velocity_vertex - velocity_edge, along);
    if (!numer.is_certain() || !denom.is_certain()) return When::unsure;
    if ((numer.value < 0) != (denom.value < 0)) return When::before;
    if (length == kInfinity) return When::within;
    const double n = std::fabs(numer.value), d = length * std::fabs(denom.value);
    const double error = numer.error + length * denom.error + kDetFilter * (n + d);
    return n - d > error ? When::after : d - n > error ? When::within : When::unsure;
  }
};

typedef float Four __attribute__((vector_size(16)));
typedef std::int32_t FourInts __attribute__((vector_size(16)));

// How far four corners lie to the left, their numbers in the last bits.
Four left_of(const Ready& shape, std::size_t from, float x, float y) {
  Four corner_x, corner_y;
  std::memcpy(&corner_x, shape.lanes.x + from, sizeof corner_x);
  std::memcpy(&corner_y, shape.lanes.y + from, sizeof corner_y);
  const Four left = x * corner_y - y * corner_x;
  const auto first = static_cast<std::int32_t>(from);
  const FourInts numbers = {first, first + 1, first + 2, first + 3};
  return (Four)(((FourInts)left & ~(sweep::kCorners - 1)) | numbers);
}

// The corner farthest to the left of a direction, about.
std::size_t leftmost(const Ready& shape, const Vec2& along) {
  const auto x = static_cast<float>(along.x()), y = static_cast<float>(along.y());
  const Four low = left_of(shape, 0, x, y), high = left_of(shape, 4, x, y);
  const Four best = low > high ? low : high;
  const float most = std::max(std::max(best[0], best[1]), std::max(best[2], best[3]));
  const unsigned k = std::bit_cast<unsigned>(most) & (sweep::kCorners - 1);
  return k < static_cast<unsigned>(shape.count) ? k : 0;
}

// The edge a kernel has named, if it is one of the difference, and the origin surely crosses it:
// from left to right where it comes in.
std::optional<Meeting> meeting(const Ready* const shapes[2], const Vec2 velocities[2], float guess,
                               bool comes_in) {
  const unsigned number = std::bit_cast<unsigned>(guess) & sweep::kEdgeBits;
  const bool of_a = number < sweep::kCorners;
  const Ready &own = *shapes[of_a ? 0 : 1], &other = *shapes[of_a ? 1 : 0];
  const Vec2 &mine = velocities[of_a ? 0 : 1], &its = velocities[of_a ? 1 : 0];
  const unsigned lane = number % sweep::kCorners;
  const std::size_t k = lane < static_cast<unsigned>(own.count) ? lane : 0;
  const Vec2 &from = own.corners[k], &to = own.corners[k + 1];
  const std::size_t met = leftmost(other, to - from);
  const Vec2 &p = other.corners[met], &after = other.corners[met + 1];
  const Vec2& before = other.corners[(met == 0 ? static_cast<std::size_t>(other.count) : met) - 1];
  const Sign side = comes_in ? Sign::positive : Sign::negative;
  if (cross_sign(mine, its, p, from) != side || cross_sign(mine, its, p, to) != -side ||
      cross_sign(from, to, p, after) != Sign::negative ||
      cross_sign(from, to, p, before) != Sign::negative)
    return std::nullopt;
  return Meeting{&from, &to, &p, mine, its, {of_a, own.edges[k], other.numbers[met]}};
}

struct Shadow {
  double low = kInfinity, high = -kInfinity;
};

// How far the corners of a shape are to the left of a way through a place.
Shadow shadow(const Ready& shape, const Vec2& place, const Vec2& way) {
  Shadow s;
  for (int k = 0; k < shape.count; ++k) {
    const Vec2 p = shape.corners[static_cast<std::size_t>(k)] - place;
    const double left = way.x() * p.y() - way.y() * p.x();
    s.low = left < s.low ? left : s.low;
    s.high = left > s.high ? left : s.high;
  }
  return s;
}

// Whether the one surely passes the other without ever touching it.
bool passes_beside(const Ready& a, const Ready& b, const Vec2& way) {
  const Shadow of_a = shadow(a, a.centre, way), of_b = shadow(b, a.centre, way);
  const double speed = std::fabs(way.x()) + std::fabs(way.y());
  const Vec2 between = b.centre - a.centre;
  // Three roundings of what the way is multiplied with, and those of the way itself.
  const double error =
      0x1p-48 * speed * (a.radius + b.radius + std::fabs(between.x()) + std::fabs(between.y())) +
      kDetFilterLeast;
  return of_b.low - of_a.high > error || of_a.low - of_b.high > error;
}

}  // namespace

std::optional<Contact> certain_contact(const PolygonSet& shapes, const MovingPair& pair,
                                       double length, const sweep::Guess& guess) {
  const Ready* const both[2] = {&shapes.ready(pair.a), &shapes.ready(pair.b)};
  const Vec2 velocities[2] = {pair.velocity_a, pair.velocity_b};
  if (guess.enter > -guess.leave &&
      passes_beside(*both[0], *both[1], pair.velocity_b - pair.velocity_a))
    return Contact{};
  Contact contact;
  contact.times = {0, length, kNoEdge, kNoEdge, HitClass::through, StartPlace::inside};
  // One edge properly crossed at a time in the range, or an overlap, and there is one from the
  // former to the latter.
  const bool from_start = guess.first_gap < 0;
  const bool to_end = length < kInfinity && guess.last_gap < 0;
  if (!from_start) {
    const auto in = meeting(both, velocities, guess.enter, true);
    const When when = in ? in->when(length) : When::unsure;
    if (when == When::unsure) return std::nullopt;
    if (when == When::after) return Contact{};
    if (when == When::within) {
      const RoundedTime time = in->time();
      contact.first = in->feature;
      contact.times.t_enter = time.t;
      contact.times.start = StartPlace::outside;
      contact.times.enter_overflows = time.overflows;
    }
  }
  if (!to_end) {
    const auto out = meeting(both, velocities, guess.leave, false);
    const When when = out ? out->when(length) : When::unsure;
    if (when == When::unsure) return std::nullopt;
    if (when == When::before) return Contact{};
    if (when == When::within) {
      const RoundedTime time = out->time();
      contact.last = out->feature;
      contact.times.t_exit = time.t;
      contact.times.exit_overflows = time.overflows;
    }
  }
  return contact;
}

}  // namespace flatray
