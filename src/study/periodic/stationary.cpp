#include "study/periodic/stationary.h"

#include <algorithm>
#include <cmath>

namespace flatray {
namespace {

using Square = std::vector<double>;  // row by row

constexpr int kMostSteps = 40;

// Gradient and second derivatives of the length.
struct Derivatives {
  std::vector<Near> first, second;
};

// With e the direction from A to B, of their distance: dA is -e, and what is across e counts twice.
Derivatives derivatives(const std::vector<CurvedBounce>& bounces, const std::vector<Near>& at) {
  const std::size_t n = bounces.size();
  Derivatives all{std::vector<Near>(n, 0.0), std::vector<Near>(n * n, 0.0)};
  std::vector<CurvePlace> places;
  for (std::size_t i = 0; i < n; ++i) places.push_back(curve_place(bounces[i], at[i]));
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = i + 1 < n ? i + 1 : 0;
    const CurvePlace& a = places[i];
    const Isometry<Near>& next = bounces[i].next;
    const CurvePlace b{next(places[j].point), next.turned(places[j].rate),
                       next.turned(places[j].bend)};
    const Pair<Near> way = b.point - a.point;
    const Near length = length_of(way);
    const Pair<Near> e{way.x / length, way.y / length};
    const Near across_a = cross(e, a.rate), across_b = cross(e, b.rate);
    const auto add = [](Near& to, const Near& what) { to = to + what; };
    add(all.first[i], -dot(e, a.rate));
    add(all.first[j], dot(e, b.rate));
    add(all.second[i * n + i], across_a * across_a / length - dot(e, a.bend));
    add(all.second[j * n + j], across_b * across_b / length + dot(e, b.bend));
    const Near both = -(across_a * across_b) / length;
    add(all.second[i * n + j], both);
    add(all.second[j * n + i], both);
  }
  return all;
}

// By Gauss and Jordan, with the largest pivot of a column.
std::optional<Square> inverse(Square m) {
  const auto n = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(m.size()))));
  Square made(n * n, 0.0);
  double largest = 0;
  for (const double one : m) largest = std::max(largest, std::fabs(one));
  for (std::size_t i = 0; i < n; ++i) made[i * n + i] = 1;
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t best = c;
    for (std::size_t r = c + 1; r < n; ++r)
      if (std::fabs(m[r * n + c]) > std::fabs(m[best * n + c])) best = r;
    const double pivot = m[best * n + c];
    if (!(std::fabs(pivot) > 1e-12 * largest)) return std::nullopt;
    for (std::size_t k = 0; k < n; ++k) {
      std::swap(m[best * n + k], m[c * n + k]);
      std::swap(made[best * n + k], made[c * n + k]);
      m[c * n + k] /= pivot;
      made[c * n + k] /= pivot;
    }
    for (std::size_t r = 0; r < n; ++r) {
      const double times = m[r * n + c];
      if (r == c || times == 0) continue;
      for (std::size_t k = 0; k < n; ++k) {
        m[r * n + k] -= times * m[c * n + k];
        made[r * n + k] -= times * made[c * n + k];
      }
    }
  }
  return made;
}

Square middles(const std::vector<Near>& all) {
  Square made;
  for (const Near& one : all) made.push_back(one.value());
  return made;
}

std::vector<Near> here(std::size_t n) { return std::vector<Near>(n, 0.0); }

}  // namespace

CurvePlace curve_place(const CurvedBounce& bounce, const Near& q) {
  const Ellipse& curve = bounce.arc->curve;
  const Near x(bounce.at.x()), y(bounce.at.y()), size = square_root(x * x + y * y);
  const Near a = x / size, b = y / size, one(1), two(2), four(4);
  const Pair<Near> u = near(curve.u), v = near(curve.v);
  const Pair<Near> to = a * u + b * v, across = a * v - b * u;
  const Near square = q * q, denom = one / (one + square), denom2 = denom * denom;
  const auto mix = [&](const Near& along, const Near& turned) {
    return along * to + turned * across;
  };
  const Pair<Near> from_centre = mix((one - square) * denom, two * q * denom);
  return {near(curve.centre) + from_centre,
          mix(-(four * q * denom2), two * (one - square) * denom2),
          mix((Near(12) * square - four) * denom2 * denom,
              four * q * (square - Near(3)) * denom2 * denom)};
}

bool StationaryPolygon::improve() {
  constexpr double kMost = 0.5, kStill = 1e-13;
  const std::size_t n = bounces_.size();
  for (int step = 0; step < kMostSteps; ++step) {
    const Derivatives all = derivatives(bounces_, here(n));
    const auto inverted = inverse(middles(all.second));
    if (!inverted) return false;
    double largest = 0;
    for (std::size_t i = 0; i < n; ++i) {
      double q = 0;
      for (std::size_t k = 0; k < n; ++k) q -= (*inverted)[i * n + k] * all.first[k].value();
      if (!std::isfinite(q)) return false;
      largest = std::max(largest, std::fabs(q));
      q = std::clamp(q, -kMost, kMost);
      Vec2& at = bounces_[i].at;
      const double along = 1 - q * q, turned = 2 * q;
      at = Vec2(at.x() * along - at.y() * turned, at.y() * along + at.x() * turned) / (1 + q * q);
      at /= std::sqrt(at.squaredNorm());
    }
    if (largest < kStill) return true;
  }
  return false;
}

bool StationaryPolygon::may_be_within(const std::vector<Near>& box) {
  places_ = box;
  const Derivatives all = derivatives(bounces_, box);
  return std::ranges::all_of(all.first, [](const Near& slope) { return !slope.sign(); });
}

// With C near the inverse of the second derivatives H, and f the gradient: if -C f + (1 - C H) Q
// lies inside Q, for H anywhere in the box Q about here, one solution and no other lies in Q.
bool StationaryPolygon::prove() {
  constexpr double kWider = 8, kLeast = 0x1p-50;
  const std::size_t n = bounces_.size();
  const Derivatives middle = derivatives(bounces_, here(n));
  const auto c = inverse(middles(middle.second));
  if (!c) return false;
  std::vector<Near> shifts, box;
  for (std::size_t i = 0; i < n; ++i) {
    Near shift(0.0);
    for (std::size_t k = 0; k < n; ++k) shift = shift - Near((*c)[i * n + k]) * middle.first[k];
    shifts.push_back(shift);
    box.push_back(Near::within(0, kWider * (shift.size() + shift.error()) + kLeast));
  }
  const Derivatives whole = derivatives(bounces_, box);
  places_.clear();
  for (std::size_t i = 0; i < n; ++i) {
    Near sum = shifts[i];
    for (std::size_t j = 0; j < n; ++j) {
      Near left(i == j ? 1.0 : 0.0);
      for (std::size_t k = 0; k < n; ++k)
        left = left - Near((*c)[i * n + k]) * whole.second[k * n + j];
      sum = sum + left * box[j];
    }
    if (!(std::max(sum.high(), -sum.low()) < box[i].error() * (1 - 0x1p-10))) return false;
    places_.push_back(sum);
  }
  return true;
}

}  // namespace flatray
