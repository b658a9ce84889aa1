#include "oracle/turning_contact.h"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "oracle/distance.h"

namespace flatray::oracle {
namespace {

constexpr unsigned kBits = 256;
using Long = mpf_class;

Long number(double x) { return {x, kBits}; }

template <class Number>
struct Angle {
  Number cos, sin;
};

Angle<double> turn(double angle) { return {portable::cos(angle), portable::sin(angle)}; }

// The series of an angle halved until it is small, then doubled as often.
Angle<Long> turn(Long angle) {
  int halved = 0;
  for (; abs(angle) > 0x1p-8; ++halved) angle /= 2;
  Long term = number(1), cos = number(1), sin = number(0);
  for (int k = 1; k < 40; ++k) {
    if (k % 2 == 0) term = -term;
    term = Long(term * angle / k);
    (k % 2 == 0 ? cos : sin) += term;
  }
  for (; halved > 0; --halved) {
    const Long twice = 2 * sin * cos;
    cos = 1 - 2 * sin * sin;
    sin = twice;
  }
  return {cos, sin};
}

double as(double x, double) { return x; }
Long as(double x, const Long&) { return number(x); }

template <class Number>
Number power_sum(const std::array<double, 4>& c, const Number& t) {
  const auto n = [&t](double x) { return as(x, t); };
  Number sum = n(c[3]);
  for (const int i : {2, 1, 0}) sum = Number(sum * t + n(c[static_cast<std::size_t>(i)]));
  return sum;
}

template <class Number>
Pair<Number> turned(const Angle<Number>& by, const Pair<Number>& p) {
  return {by.cos * p.x - by.sin * p.y, by.sin * p.x + by.cos * p.y};
}

template <class Number>
RingOf<Number> at_time(const TurningCore& body, const Vec2& origin, const Number& t) {
  const auto n = [&t](double x) { return as(x, t); };
  const auto angle =
      turn(power_sum({body.angle, body.spin, body.angle_bends[0], body.angle_bends[1]}, t));
  Pair<Number> at = pair_of(n, body.at) - pair_of(n, origin) + t * pair_of(n, body.velocity);
  for (const CoreSwing& swing : body.swings)
    at = at + turned(turn(power_sum(swing.angle, t)),
                     Pair<Number>{power_sum(swing.x, t), power_sum(swing.y, t)});
  RingOf<Number> ring;
  for (const Vec2& p : body.ring) ring.push_back(at + turned(angle, pair_of(n, p)));
  return ring;
}

template <class Number>
Number area(const Pair<Number>& a, const Pair<Number>& b, const Pair<Number>& c) {
  return cross(b - a, c - a);
}

// Of a ring with an inside, counter-clockwise.
template <class Number>
bool holds(const RingOf<Number>& ring, const Pair<Number>& p) {
  if (ring.size() < 3) return false;
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (area(ring[i], ring[(i + 1) % ring.size()], p) < 0) return false;
  return true;
}

// At inner points of both: what only touches does so with a corner.
template <class Number>
bool sides_cross(const RingOf<Number>& a, const RingOf<Number>& b) {
  const auto differ = [](const Number& p, const Number& q) {
    return (p < 0 && q > 0) || (p > 0 && q < 0);
  };
  if (a.size() < 2 || b.size() < 2) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < b.size(); ++k) {
      const auto &p = a[i], &q = a[(i + 1) % a.size()], &r = b[k], &s = b[(k + 1) % b.size()];
      if (differ(area(p, q, r), area(p, q, s)) && differ(area(r, s, p), area(r, s, q))) return true;
    }
  return false;
}

template <class Number>
bool cores_meet(const RingOf<Number>& a, const RingOf<Number>& b) {
  const auto holds_any = [](const auto& ring, const auto& points) {
    return std::any_of(points.begin(), points.end(), [&](const auto& p) { return holds(ring, p); });
  };
  return holds_any(b, a) || holds_any(a, b) || sides_cross(a, b);
}

double distance(const TurningCore& a, const TurningCore& b, double t) {
  const RingOf<double> p = at_time(a, a.at, t), q = at_time(b, a.at, t);
  if (cores_meet(p, q)) return -1;
  return std::sqrt(squared_gap(p, q)) - a.radius - b.radius;
}

double reach(const TurningCore& body) {
  double most = 0;
  for (const Vec2& p : body.ring) most = std::max(most, p.norm());
  return most;
}

// At most, up to a time.
double size(const std::array<double, 4>& c, double t) {
  return std::fabs(c[0]) + t * (std::fabs(c[1]) + t * (std::fabs(c[2]) + t * std::fabs(c[3])));
}
double pace(const std::array<double, 4>& c, double t) {
  return std::fabs(c[1]) + t * (2 * std::fabs(c[2]) + t * 3 * std::fabs(c[3]));
}
double own_speed(const TurningCore& body, double t) {
  double speed = pace({0, body.spin, body.angle_bends[0], body.angle_bends[1]}, t) * reach(body);
  for (const CoreSwing& swing : body.swings)
    speed += pace(swing.x, t) + pace(swing.y, t) +
             pace(swing.angle, t) * (size(swing.x, t) + size(swing.y, t));
  return speed;
}

constexpr double kClose = 1e-9;
constexpr FirstTouch kUnknown{FirstTouch::Kind::unknown, 0, 0};

// The touch that follows at once on a time when they are close; `step` closes no more than kClose.
FirstTouch touch_after(const TurningCore& a, const TurningCore& b, double from, double length,
                       double step) {
  if (apart_at(a, b, from) < 0) return {FirstTouch::Kind::touch, from, from};
  double low = from, high = from;
  for (double after = step; after < 1e6 * step; after *= 2) {
    high = std::min(from + after, length);
    if (apart_at(a, b, high) < 0) break;
    low = high;
    if (high == length) return kUnknown;
  }
  if (low == high) return kUnknown;
  while (true) {
    const double middle = low + 0.5 * (high - low);
    if (middle <= low || middle >= high) return {FirstTouch::Kind::touch, low, high};
    (apart_at(a, b, middle) < 0 ? high : low) = middle;
  }
}

}  // namespace

int apart_at(const TurningCore& a, const TurningCore& b, double t) {
  const RingOf<Long> p = at_time(a, a.at, number(t)), q = at_time(b, a.at, number(t));
  if (cores_meet(p, q)) return -1;
  const Long radii = number(a.radius) + number(b.radius);
  if (radii == 0) return 1;
  return squared_gap(p, q) > radii * radii ? 1 : -1;
}

FirstTouch first_touch(const TurningCore& a, const TurningCore& b, double length) {
  constexpr int kMostClose = 16;
  const double speed = 1e-300 + (1 + 1e-12) * ((b.velocity - a.velocity).norm() +
                                               own_speed(a, length) + own_speed(b, length));
  const double step = kClose / speed;
  double now = 0;
  int close_before = 0;
  while (true) {
    const double apart = distance(a, b, now);
    if (apart > kClose) {
      now += (apart - 0.5 * kClose) / speed;
      if (now < length) continue;
      return close_before > 0 ? kUnknown : FirstTouch{FirstTouch::Kind::none, 0, 0};
    }
    const double from = std::max(0.0, now - 2 * kClose / speed);
    if (const FirstTouch touch = touch_after(a, b, from, length, step);
        touch.kind == FirstTouch::Kind::touch)
      return touch;
    now += step;
    if (++close_before > kMostClose || now >= length) return kUnknown;
  }
}

}  // namespace flatray::oracle
