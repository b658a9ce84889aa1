#include "geom/ellipse.h"

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "geom/turn.h"

namespace flatray {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kMostChords = 0x1p17;  // a full turn

// Adds the t strictly inside the arc at which one coordinate turns round: those of `first` + k pi.
void add_turns(const EllipseArc& arc, double first, std::vector<double>& cuts) {
  const double to = arc.from + arc.sweep, low = std::min(arc.from, to);
  const double high = std::max(arc.from, to);
  for (double t = first + kPi * std::ceil((low - first) / kPi); t < high; t += kPi)
    if (t > low) cuts.push_back(t);
}

void go_to(const Vec2& point, std::vector<Vec2>& points) {
  if (points.empty() || points.back() != point) points.push_back(point);
}

void flatten(const EllipseArc& arc, double sagitta, std::vector<Vec2>& points) {
  const double chords = chord_count(arc, sagitta);
  go_to(arc.start(), points);
  if (chords == 0) return;
  for (double i = 1; i < chords; ++i) go_to(arc.at(arc.from + arc.sweep * (i / chords)), points);
  go_to(arc.end(), points);
}

}  // namespace

Vec2 EllipseArc::at(double t) const {
  const Turn turned = turn(t);
  if (turned.sin == 0) return centre + turned.cos * u;
  if (turned.cos == 0) return centre + turned.sin * v;
  return centre + turned.cos * u + turned.sin * v;
}

std::vector<MonotoneArc> monotone_parts(const EllipseArc& arc) {
  std::vector<double> cuts;
  add_turns(arc, portable::atan2(arc.v.x(), arc.u.x()), cuts);
  add_turns(arc, portable::atan2(arc.v.y(), arc.u.y()), cuts);
  std::sort(cuts.begin(), cuts.end());
  if (arc.sweep < 0) std::reverse(cuts.begin(), cuts.end());
  std::vector<MonotoneArc> parts;
  Vec2 last = arc.start();
  const auto go_on = [&](const Vec2& next) {
    if (next != last) parts.push_back({last, next});
    last = next;
  };
  for (const double t : cuts) go_on(arc.at(t));
  go_on(arc.end());
  return parts;
}

Bounds path_bounds(const ArcPath& path) {
  Bounds bounds;
  for (const EllipseArc& arc : path.arcs) {
    bounds.add(arc.start());
    for (const MonotoneArc& part : monotone_parts(arc)) bounds.add(part.b);
  }
  return bounds;
}

double chord_count(const EllipseArc& arc, double sagitta) {
  // A chord of a circle under angle a lies within r (1 - cos(a / 2)) <= r a^2 / 8 of it; the
  // ellipse is its affine image, which stretches no distance more than this.
  const double reach = std::sqrt(arc.u.squaredNorm() + arc.v.squaredNorm());
  if (reach == 0) return 0;
  const double step = std::max(std::sqrt(8 * sagitta / reach), 2 * kPi / kMostChords);
  return std::ceil(std::abs(arc.sweep) / std::min(step, kPi / 4));
}

std::vector<Vec2> flattened(const ArcPath& path, double sagitta) {
  std::vector<Vec2> points;
  for (const EllipseArc& arc : path.arcs) flatten(arc, sagitta, points);
  if (path.closed && !points.empty()) go_to(points.front(), points);
  return points;
}

std::vector<PathWall> walls_of(const ArcPath& path) {
  const auto is_point = [](const EllipseArc& arc) { return arc.u == arc.v && arc.u == Vec2(0, 0); };
  std::vector<PathWall> walls;
  const auto join = [&](const Vec2& from, const Vec2& to) {
    if (from != to) walls.push_back({from, to, std::nullopt});
  };
  for (std::size_t i = 0; i < path.arcs.size(); ++i) {
    const EllipseArc& arc = path.arcs[i];
    if (!is_point(arc)) walls.push_back({arc.start(), arc.end(), arc});
    if (i + 1 < path.arcs.size())
      join(arc.end(), path.arcs[i + 1].start());
    else if (path.closed && !path.is_ellipse())
      join(arc.end(), path.arcs[0].start());
  }
  return walls;
}

}  // namespace flatray
