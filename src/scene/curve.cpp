#include "scene/curve.h"

#include <algorithm>
#include <cmath>

namespace flatray {
namespace {

double rise(const Curve& curve, std::size_t i) { return curve.values[i + 1] - curve.values[i]; }
double span(const Curve& curve, std::size_t i) { return curve.times[i + 1] - curve.times[i]; }

double slope(const Curve& curve, std::size_t key) {
  if (key == 0 || key + 1 == curve.times.size()) return 0;
  const double h = span(curve, key - 1), k = span(curve, key);
  const double d = rise(curve, key - 1) / h, e = rise(curve, key) / k;
  if (!((d > 0 && e > 0) || (d < 0 && e < 0))) return 0;
  const double sum = (h + 2 * k) / d + (2 * h + k) / e, all = 3 * (h + k);
  if (std::isnormal(sum)) return all / sum;
  const double v = (h + 2 * k) / all, w = (2 * h + k) / all;
  return std::abs(d) < std::abs(e) ? d / (v + w * (d / e)) : e / (v * (e / d) + w);
}

double smooth(const Curve& curve, std::size_t i, double u) {
  const double h = span(curve, i);
  const double bend = (1 - u) * slope(curve, i) - u * slope(curve, i + 1);
  return curve.values[i] + u * u * (3 - 2 * u) * rise(curve, i) + h * u * (1 - u) * bend;
}

// The terms of `smooth` by powers of u - from, which goes up by `way`.
Cubic<double> smooth_from(const Curve& curve, std::size_t i, double from, double way) {
  const double p = span(curve, i) * slope(curve, i), q = span(curve, i) * slope(curve, i + 1);
  const double square = 3 * rise(curve, i) - 2 * p - q, cube = p + q - 2 * rise(curve, i);
  return {{smooth(curve, i, from), way * (p + from * (2 * square + 3 * from * cube)),
           way * way * (square + 3 * from * cube), way * way * way * cube}};
}

}  // namespace

double value_at(const Curve& curve, double time) {
  const auto after = std::ranges::upper_bound(curve.times, time);
  if (after == curve.times.begin()) return curve.values.front();
  const auto i = static_cast<std::size_t>(after - curve.times.begin()) - 1;
  if (after == curve.times.end() || curve.times[i] == time || curve.ease == Curve::Ease::step)
    return curve.values[i];
  const double u = (time - curve.times[i]) / span(curve, i);
  const double value = curve.ease == Curve::Ease::smooth ? smooth(curve, i, u)
                                                         : curve.values[i] + u * rise(curve, i);
  const auto [low, high] = std::minmax(curve.values[i], curve.values[i + 1]);
  return std::clamp(value, low, high);
}

Cubic<double> cubic_between(const Curve& curve, double from, double to) {
  const double middle = from + 0.5 * (to - from);
  const auto after = std::ranges::upper_bound(curve.times, middle);
  const double begin = value_at(curve, from);
  const bool rests =
      after == curve.times.begin() || after == curve.times.end() || curve.ease == Curve::Ease::step;
  if (rests) return linear(begin, 0);
  if (curve.ease == Curve::Ease::linear) return linear(begin, value_at(curve, to) - begin);
  const auto i = static_cast<std::size_t>(after - curve.times.begin()) - 1;
  const double h = span(curve, i);
  return smooth_from(curve, i, (from - curve.times[i]) / h, (to - from) / h);
}

double lowest(const Curve& curve) { return *std::ranges::min_element(curve.values); }

double highest(const Curve& curve) { return *std::ranges::max_element(curve.values); }

PathPoint point_at(const Path& path, double length) {
  const double whole = path.lengths.back();
  double way = std::clamp(length, 0.0, whole);
  if (path.closed) {
    way = length - whole * std::floor(length / whole);
    if (!(way >= 0 && way < whole)) way = 0;
  }
  const auto after = std::upper_bound(path.lengths.begin(), path.lengths.end() - 1, way);
  const auto i = static_cast<std::size_t>(after - path.lengths.begin()) - 1;
  const Vec2 from = path.points[i], edge = path.points[i + 1] - from;
  if (way == path.lengths[i + 1]) return {path.points[i + 1], edge};
  return {from + (way - path.lengths[i]) / (path.lengths[i + 1] - path.lengths[i]) * edge, edge};
}

}  // namespace flatray
