#include "oracle/candidates.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geom/pair.h"
#include "geom/primitives/wall.h"

namespace flatray::oracle {
namespace {

using LongDouble = long double;
static_assert(std::numeric_limits<LongDouble>::digits >= 64 &&
              std::numeric_limits<LongDouble>::max_exponent >= 16384);

// One rounding. A product of two differences is off by three and their squares, the difference of
// two such by one more: five cover them.
constexpr LongDouble kRounding = std::numeric_limits<LongDouble>::epsilon() / 2;

// A number known to lie within `error` of `value`.
struct Known {
  LongDouble value, error;
  bool positive() const { return value > error; }
  bool negative() const { return -value > error; }
};

using WidePoint = Pair<LongDouble>;
WidePoint wide(const Vec2& v) {
  return {static_cast<LongDouble>(v.x()), static_cast<LongDouble>(v.y())};
}

// a x b of differences of doubles.
Known area(const WidePoint& a, const WidePoint& b) {
  const LongDouble left = a.x * b.y, right = a.y * b.x;
  return {left - right, 5 * kRounding * (std::fabs(left) + std::fabs(right))};
}

// The length of v, which rounds three times, and not less.
LongDouble length_above(const WidePoint& v) { return std::sqrt(dot(v, v)) * (1 + 8 * kRounding); }

// Whether all of a wall lies behind the ray's start on one axis.
bool is_behind(double origin, double direction, double a, double b) {
  if (direction >= 0 && a < origin && b < origin) return true;
  return direction <= 0 && a > origin && b > origin;
}

// When a wall is met whose ends lie on different sides of the ray's line.
Candidate crossing(std::int64_t wall, Known time, const Known& from, const Known& to) {
  Known across{to.value - from.value, from.error + to.error};
  across.error += kRounding * std::fabs(across.value);
  if (across.value < 0) {
    across.value = -across.value;
    time.value = -time.value;
  }
  if (time.negative()) return {};
  if (!time.positive() || !across.positive()) return {wall};
  // Differences and quotients round three times.
  const LongDouble low = (time.value - time.error) / (across.value + across.error);
  const LongDouble high = (time.value + time.error) / (across.value - across.error);
  return {wall, true, low * (1 - 8 * kRounding), high * (1 + 8 * kRounding)};
}

Candidate candidate(const Ray& ray, const Segment& segment, std::int64_t wall) {
  const WidePoint o = wide(ray.origin), d = wide(ray.direction);
  const WidePoint to_a = wide(segment.a) - o, to_b = wide(segment.b) - o;
  const Known a = area(d, to_a), b = area(d, to_b);
  if ((a.positive() && b.positive()) || (a.negative() && b.negative())) return {};
  const bool apart = (a.positive() && b.negative()) || (a.negative() && b.positive());
  return apart ? crossing(wall, area(to_a, to_b), a, b) : Candidate{wall};
}

}  // namespace

void find_candidates(const Ray& ray, std::span<const Segment> walls,
                     std::vector<Candidate>& candidates) {
  candidates.clear();
  const Vec2 &o = ray.origin, &d = ray.direction;
  LongDouble first = std::numeric_limits<LongDouble>::infinity();
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const Segment& wall = walls[i];
    if (is_behind(o.x(), d.x(), wall.a.x(), wall.b.x()) ||
        is_behind(o.y(), d.y(), wall.a.y(), wall.b.y()))
      continue;
    const Candidate found = candidate(ray, wall, static_cast<std::int64_t>(i));
    if (found.wall < 0 || found.low > first) continue;
    if (found.sure) first = std::min(first, found.high);
    candidates.push_back(found);
  }
  std::erase_if(candidates, [&](const Candidate& each) { return each.low > first; });
}

// So that all points are within.
static Reach around(Reach reach, std::span<const Vec2> points) {
  for (const Vec2& p : points)
    reach.radius = std::max(reach.radius, length_above(wide(p) - wide(reach.centre)));
  return reach;
}
Reach reach_of(const Arc& arc) {
  const auto& [centre, u, v] = arc.curve;
  const auto circle = circle_along(arc);
  if (whole_circle(arc)) return {centre, static_cast<LongDouble>(circle->radius), true};
  const LongDouble sum = circle ? static_cast<LongDouble>(circle->radius)
                                : length_above(wide(u)) + length_above(wide(v));
  const Reach whole{centre, sum * (1 + kRounding * 4)};
  return arc.extent == Arc::Extent::between ? around(whole, std::array{arc.from, arc.to}) : whole;
}
Reach reach_of(const Bezier& curve) {
  return around({curve.points[0]},
                std::span(curve.points).first(static_cast<std::size_t>(curve.degree) + 1));
}
Reach reach_of(const Segment& wall) { return around({wall.a}, std::array{wall.b}); }

// With w from the start to the centre, all of a disc lies where t d.d is between d.w - r |d| and
// d.w + r |d|, and nowhere if |d x w| is more than r |d|.
void find_candidates(const Ray& ray, std::span<const Reach> curves, long double first,
                     std::vector<Candidate>& candidates) {
  candidates.clear();
  const WidePoint o = wide(ray.origin), d = wide(ray.direction);
  const LongDouble length = length_above(d), square = length * length;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const Reach& disc = curves[i];
    const WidePoint w = wide(disc.centre) - o;
    const LongDouble margin = disc.radius * (1 + 8 * kRounding);
    if (std::max(std::fabs(w.x), std::fabs(w.y)) > margin && length == 0) continue;
    const Known beside = area(d, w), ahead = area(d, {-w.y, w.x});  // d x w and d.w
    const LongDouble reach = margin * length;
    if (std::fabs(beside.value) - beside.error > reach) continue;
    if (-ahead.value - ahead.error > reach) continue;
    Candidate found{static_cast<std::int64_t>(i)};
    if (length > 0)
      found.low = std::max<LongDouble>(
          0, (ahead.value - ahead.error - reach) / square * (1 - 64 * kRounding));
    found.sure = disc.is_border && ahead.positive() &&
                 std::fabs(beside.value) + beside.error < reach * (1 - 64 * kRounding);
    if (found.sure) {
      found.high = (ahead.value + ahead.error + reach) / square * (1 + 64 * kRounding);
      first = std::min(first, found.high);
    }
    candidates.push_back(found);
  }
  std::erase_if(candidates, [&](const Candidate& each) { return each.low > first; });
}

}  // namespace flatray::oracle
