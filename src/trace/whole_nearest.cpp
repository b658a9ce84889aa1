#include "trace/whole_nearest.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <compare>
#include <cstdint>

#include "geom/bounds.h"
#include "geom/error_free.h"
#include "trace/kernels/tiers.h"

namespace flatray {
namespace {

constexpr int kUnitDigits = 25;
constexpr double kMostUnits = 0x1p25, kLeastUnit = 0x1p-200, kMostUnit = 0x1p200;

// The last digit of a number, in base two; of 0, which is a multiple of all, infinity.
double last_digit(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const bool is_power_or_zero = bits << 12 == 0;
  const double last = is_power_or_zero ? x : x - std::bit_cast<double>(bits & (bits - 1));
  return last == 0 ? kInfinity : std::fabs(last);
}
double last_digit(const Vec2& v) { return std::min(last_digit(v.x()), last_digit(v.y())); }

double largest(const Vec2& v) { return std::max(v.x(), v.y()); }

std::strong_ordering order(const DoubleDouble& a, const DoubleDouble& b) {
  const double difference = a.hi != b.hi ? a.hi - b.hi : a.lo - b.lo;
  return difference < 0   ? std::strong_ordering::less
         : difference > 0 ? std::strong_ordering::greater
                          : std::strong_ordering::equal;
}

}  // namespace

WholeWalls::WholeWalls(const Surfaces& walls) {
  if (!walls.arcs.empty() || walls.segments.empty()) return;
  Bounds box;
  for (const Segment& wall : walls.segments) {
    box.add(wall.a);
    box.add(wall.b);
    unit_ = std::min({unit_, last_digit(wall.a), last_digit(wall.b)});
    if (largest(box.size()) >= kMostUnits * unit_) return;
  }
  if (unit_ == kInfinity) return;  // all ends are (0, 0)
  // Digits to spare are shared: origins may have more than the walls, and lie beside them.
  const double side = largest(box.size());
  const int coarsest = std::ilogb(unit_);
  const int finest = side > 0 ? std::ilogb(side) + 1 - kUnitDigits : coarsest;
  const double unit = std::ldexp(1, (finest + coarsest) / 2);
  any_ = kLeastUnit <= unit && unit <= kMostUnit;
  const double reach = kMostUnits / 2 * unit;
  const Vec2 sides = box.size() + Vec2(reach, reach);
  box_ = {box.low.x(), box.low.y(), reach, sides.x(), sides.y(), 0x1.8p52 * unit};
}

bool WholeWalls::hold(const Ray& ray) const {
  if (!any_) return false;
  const Vec2 &o = ray.origin, &d = ray.direction;
  double whole;
  lane_kernels(Isa::portable).whole.hold(box_, {&o.x(), &o.y(), &d.x(), &d.y(), 1}, &whole);
  return whole != 0;
}

void WholeNearest::offer(std::uint32_t slot) {
  const Segment& wall = walls_.segments[slot];
  const Vec2 a = wall.a - ray_.origin, b = wall.b - ray_.origin, &d = ray_.direction;
  const double side_a = cross(d, a), side_b = cross(d, b), across = side_b - side_a;
  if (side_a * side_b > 0) return;
  const std::uint32_t number = walls_.segment_numbers[slot];
  if (across == 0) return offer_along(number, a, b);
  const double ahead = across < 0 ? -cross(a, b) : cross(a, b);
  if (ahead < 0) return;
  const bool at_end = side_a == 0 || side_b == 0;
  offer({number, HitClass::touch, Root::none, at_end, 0}, {ahead, std::fabs(across)});
}

// The rules of ExactNearest; a wall that is a point is met in it.
void WholeNearest::offer_along(std::uint32_t number, const Vec2& a, const Vec2& b) {
  const double at_a = ray_.direction.dot(a), at_b = ray_.direction.dot(b);
  const double near = std::min(at_a, at_b), far = std::max(at_a, at_b);
  if (far < 0) return;
  const bool at_end = far == 0 || near >= 0;
  const HitClass kind = far == 0 || near == far ? HitClass::touch : HitClass::along;
  offer({number, kind, Root::none, at_end, 0}, {std::max(near, 0.0), ray_.direction.squaredNorm()});
}

// Rounding keeps order, so that exact times are compared only where the doubles are equal.
void WholeNearest::offer(NearestHit hit, const Time& time) {
  hit.t = time.numer / time.denom + 0.0;  // never -0
  if (hit.t > best_.t) return;
  if (hit.t == best_.t) {
    const std::strong_ordering later =
        order(two_product(time.numer, time_.denom), two_product(time_.numer, time.denom));
    if (later > 0 || (later == 0 && hit.surface > best_.surface)) return;
  }
  best_ = hit;
  time_ = time;
}

}  // namespace flatray
