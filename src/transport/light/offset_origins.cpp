#include "transport/light/offset_origins.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geom/box_tree.h"
#include "geom/decide.h"
#include "geom/interval_set.h"
#include "geom/primitives/wall.h"

namespace flatray {
namespace {

constexpr double kLeastSize = 0x1p-128, kMostSize = 0x1p128;  // sixth powers are doubles
constexpr double kApart = 0x1p-36, kDistance = 0x1p-44, kFarthestOff = 0x1p4, kLeastBend = 0x1p-20;
constexpr std::size_t kMostLooks = std::size_t{1} << 26;
constexpr std::size_t kMostPairs = 1U << 16,
                      kMostPairsOfWall = 16;   // that are kept, and a wall more
constexpr std::uint32_t kMostNeighbours = 16;  // of a curve

// How far from the centre of a curve a point is: 1 on it, in proportion along each line.
double share_of_radius(const Ellipse& curve, const Vec2& point) {
  const auto form = curve_form(kPlain, curve, pair_of(kPlain, Vec2(point - curve.centre)));
  return std::sqrt(dot(form, form)) / form_size(kPlain, curve);
}

// What of a wall lies farthest to any side; its box, where it is curved.
std::array<Vec2, 4> corners(const Segment& wall, const Bounds&) {
  return {wall.a, wall.b, wall.a, wall.b};
}
template <class Curve>
std::array<Vec2, 4> corners(const Curve&, const Bounds& box) {
  return {box.low, box.high, Vec2(box.low.x(), box.high.y()), Vec2(box.high.x(), box.low.y())};
}

Vec2 along(const Vec2& normal) { return {normal.y(), -normal.x()}; }

}  // namespace

OffsetOrigins::OffsetOrigins(const Surfaces& walls) : walls_(walls), table_(walls.size()) {
  const Bounds all = bounds_of(walls);
  const double size = std::max(all.low.cwiseAbs().maxCoeff(), all.high.cwiseAbs().maxCoeff());
  if (!(size > kLeastSize && size < kMostSize)) return;
  apart_ = kApart * size, distance_ = kDistance * size, farthest_ = kFarthestOff * size;
  for (std::uint32_t i = 0; i < walls.size(); ++i)
    table_[i] = walls.visit(i, [&](const auto& each) { return wall(each); });
  find_neighbours();
}

OffsetOrigins::Wall OffsetOrigins::wall(const Segment& ends) const {
  Wall made;
  const Vec2 edge = ends.b - ends.a;
  made.at = ends.a;
  made.length = std::sqrt(edge.squaredNorm());
  made.is_plain = made.ready = made.length > apart_;
  if (made.ready) made.normal = Vec2(-edge.y(), edge.x()) / made.length;
  return made;
}

OffsetOrigins::Wall OffsetOrigins::wall(const Arc& arc) const {
  Wall made;
  const HalfAxes half = half_axes(arc.curve);
  made.at = arc.curve.centre;
  made.length = half.least;
  const bool is_round =
      half.least > 0 && half.least * half.least > kLeastBend * (distance_ / kDistance) * half.most;
  const auto joins = [&](const Vec2& end) {
    return std::fabs(share_of_radius(arc.curve, end) - 1) * half.most < apart_ / 4;
  };
  made.is_plain =
      is_round && (arc.extent != Arc::Extent::between || (joins(arc.from) && joins(arc.to)));
  made.ready = made.is_plain && arc.extent != Arc::Extent::half;
  return made;
}

// Where all legs of its control polygon lead along its chord, at angles of a cosine above 1/4, so does the
// curve: it passes by no place again. An arc of a conic turns to one side, by less than half a turn: there
// 1/16 will do, which tells its places along the chord well enough apart.
OffsetOrigins::Wall OffsetOrigins::wall(const Bezier& curve) const {
  const double least_ahead = curve.degree == 2 ? 0x1p-4 : 0.25;
  const auto length = [](const Vec2& v) { return std::sqrt(v.squaredNorm()); };
  const Vec2 chord = curve.end() - curve.start();
  Wall made;
  made.at = curve.start();
  made.length = length(chord);
  made.is_plain = true;
  if (!(made.length > apart_)) return made;
  made.normal = chord / made.length;
  double ahead = kInfinity, longest = 0, bend = 0;
  const Bernstein<Vec2> legs = legs_of(curve);
  for (std::size_t k = 0; k < legs.size(); ++k) {
    ahead = std::min(ahead, made.normal.dot(legs[k])), longest = std::max(longest, length(legs[k]));
    if (k > 0) bend = std::max(bend, length(legs[k] - legs[k - 1]));
  }
  const double n = curve.degree, speed = n * ahead;
  const double most_weight = std::max(curve.weight, 1.0);
  const double turning =
      n * static_cast<double>(legs.size() - 1) * bend * (most_weight * most_weight);
  made.ready = ahead > least_ahead * longest &&
               speed * speed > kLeastBend * (distance_ / kDistance) * turning;
  return made;
}

void OffsetOrigins::find_neighbours() {
  const auto count = static_cast<std::uint32_t>(walls_.size());
  std::vector<Bounds> boxes;
  const Vec2 around = Vec2::Constant(2 * apart_);
  for (std::uint32_t i = 0; i < count; ++i) {
    const Bounds box = walls_.visit(i, [](const auto& wall) { return bounds_of(wall); });
    boxes.push_back({box.low - around, box.high + around});
  }
  const BoxTree tree(boxes);
  std::size_t looks = 0, kept = 0;
  std::vector<std::uint32_t> others;
  for (std::uint32_t i = 0; i < count; ++i) {
    others.clear();
    const std::vector<std::size_t> overlap = tree.near(boxes[i]);
    for (const std::size_t near : overlap) {
      const auto other = static_cast<std::uint32_t>(near);
      if (other != i && !are_far(i, other, boxes[other]) && !are_far(other, i, boxes[i]))
        others.push_back(other);
    }
    looks += overlap.size(), kept += others.size();
    if (looks > kMostLooks || kept > 2 * (kMostPairs + kMostPairsOfWall * count)) {
      for (Wall& wall : table_) wall.ready = false;
      return;
    }
    std::ranges::sort(others);
    if (!others.empty())
      walls_.visit(i, [&](const auto& wall) { keep_neighbours(wall, table_[i], others); });
  }
}

template <class Curve>
void OffsetOrigins::keep_neighbours(const Curve&, Wall& wall,
                                    std::span<const std::uint32_t> others) {
  wall.begin = static_cast<std::uint32_t>(near_.size());
  near_.insert(near_.end(), others.begin(), others.end());
  wall.end = static_cast<std::uint32_t>(near_.size());
  wall.ready = wall.ready && others.size() <= kMostNeighbours;
}

void OffsetOrigins::keep_neighbours(const Segment&, Wall& wall,
                                    std::span<const std::uint32_t> others) {
  std::vector<Range> found;
  for (const std::uint32_t i : others) {
    if (table_[i].is_plain)
      walls_.visit(i, [&](const auto& other) { add_near(wall, other, table_[i], found); });
    else
      found.push_back({-3 * apart_, wall.length + 3 * apart_});
  }
  const IntervalSet apart = interval_set(std::move(found));
  wall.begin = static_cast<std::uint32_t>(stretches_.size());
  stretches_.insert(stretches_.end(), apart.begin(), apart.end());
  wall.end = static_cast<std::uint32_t>(stretches_.size());
}

// Where a segment is near the line of another and not beyond its ends, both linear along it, or near
// a whole curve, on both sides of what lies inside. A quotient by less than kLeastSlope would not be
// certain.
void OffsetOrigins::add_near(const Wall& wall, const Segment&, const Wall& second,
                             std::vector<Range>& found) const {
  constexpr double kLeastSlope = 0x1p-10;
  const double far = 3 * apart_;
  const Vec2 way = along(wall.normal);
  Range near{-far, wall.length + far};
  const auto within = [&](const Vec2& axis, double low, double high) {
    const double start = axis.dot(wall.at - second.at), slope = axis.dot(way);
    if (std::fabs(slope) < kLeastSlope) return;
    const auto [from, to] = std::minmax({(low - start) / slope, (high - start) / slope});
    near = {std::max(near.low, from), std::min(near.high, to)};
  };
  within(second.normal, -far, far);
  within(along(second.normal), -far, second.length + far);
  found.push_back(near);
}

void OffsetOrigins::add_near(const Wall& wall, const Arc& other, const Wall& second,
                             std::vector<Range>& found) const {
  const Ellipse& curve = other.curve;
  const auto form = [&](const Vec2& v) { return curve_form(kPlain, curve, pair_of(kPlain, v)); };
  const auto start = form(wall.at - curve.centre), slope = form(along(wall.normal));
  const double speed = std::sqrt(dot(slope, slope)), size = form_size(kPlain, curve);
  const double middle = -dot(start, slope) / speed, off = std::fabs(cross(start, slope)) / speed;
  const auto half = [&](double radius) {
    return std::sqrt(std::max((radius - off) * (radius + off), 0.0));
  };
  const double margin = size * (3 * apart_ / second.length);
  const double inner = half(size - margin), outer = half(size + margin);
  found.push_back({(middle - outer) / speed, (middle - inner) / speed});
  found.push_back({(middle + inner) / speed, (middle + outer) / speed});
}

// By halves of its control polygon, as far as they come near.
void OffsetOrigins::add_near(const Wall& wall, const Bezier& other, const Wall&,
                             std::vector<Range>& found) const {
  constexpr int kHalvings = 12;
  const double far = 3 * apart_;
  using Form = Bernstein<double>;
  const auto by = [&](const Vec2& axis) {
    return bernstein_of(kPlain, other, [&](const Vec2& p) { return axis.dot(p - wall.at); });
  };
  const auto range = [](const Form& form, const Form& weights) {
    Range of{kInfinity, -kInfinity};
    for (std::size_t k = 0; k < form.size(); ++k) {
      const double value = form[k] / weights[k];
      of = {std::min(of.low, value), std::max(of.high, value)};
    }
    return of;
  };
  const auto add = [&](const auto& self, const Form& off, const Form& place, const Form& weights,
                       int halvings) -> void {
    const Range offs = range(off, weights), places = range(place, weights);
    if (offs.low > far || offs.high < -far) return;
    if (halvings == 0 || (offs.low >= -far && offs.high <= far)) {
      found.push_back({places.low - far, places.high + far});
      return;
    }
    const auto off_halves = halves(off, 0.5), place_halves = halves(place, 0.5),
               weight_halves = halves(weights, 0.5);
    for (std::size_t part = 0; part < 2; ++part)
      self(self, off_halves[part], place_halves[part], weight_halves[part], halvings - 1);
  };
  add(add, by(wall.normal), by(along(wall.normal)), weights_of(kPlain, other), kHalvings);
}

// Whether all of wall b, or of its box, is on one side of segment a, or of its ends, or inside curve a.
bool OffsetOrigins::are_far(std::uint32_t a, std::uint32_t b, const Bounds& box) const {
  if (!table_[a].is_plain) return false;
  const auto points = walls_.visit(b, [&](const auto& other) { return corners(other, box); });
  return walls_.visit(a, [&](const auto& wall) { return are_far(wall, table_[a], points); });
}

bool OffsetOrigins::are_far(const Arc& arc, const Wall& wall, std::span<const Vec2> points) const {
  return std::ranges::all_of(points, [&](const Vec2& point) {
    return (1 - share_of_radius(arc.curve, point)) * wall.length > 4 * apart_;
  });
}

bool OffsetOrigins::are_far(const Segment&, const Wall& wall, std::span<const Vec2> points) const {
  const double far = 4 * apart_;
  const auto apart = [&](const Vec2& axis, double low, double high) {
    double least = kInfinity, most = -kInfinity;
    for (const Vec2& point : points) {
      const double place = axis.dot(point - wall.at);
      least = std::min(least, place), most = std::max(most, place);
    }
    return least > high + far || most < low - far;
  };
  return apart(wall.normal, 0, 0) || apart(along(wall.normal), 0, wall.length);
}

bool OffsetOrigins::is_far(const Arc& arc, const Wall& wall, const Vec2& point) const {
  return std::fabs(share_of_radius(arc.curve, point) - 1) * wall.length > 2 * apart_;
}

bool OffsetOrigins::is_far(const Segment&, const Wall& wall, const Vec2& point) const {
  const double far = 2 * apart_;
  const Vec2 from = point - wall.at;
  const double place = along(wall.normal).dot(from);
  return std::fabs(wall.normal.dot(from)) > far || place < -far || place > wall.length + far;
}

bool OffsetOrigins::is_far(const Bezier& curve, const Wall&, const Vec2& point) const {
  return !passes_near(curve, point, Vec2::Constant(2 * apart_));
}

bool OffsetOrigins::ends_far(const Vec2& one, const Vec2& other, const Vec2& point) const {
  const auto far = [&](const Vec2& end) {
    return (point - end).cwiseAbs().maxCoeff() > 2 * apart_;
  };
  return far(one) && far(other);
}

std::optional<OffsetOrigins::WallPoint> OffsetOrigins::meet(const Ray& ray,
                                                            const NearestHit& hit) const {
  const Wall& wall = table_[hit.surface];
  const bool crosses = hit.kind != HitClass::along && hit.root != Root::both && !hit.at_end;
  if (!wall.ready || !crosses || !(ray.origin.cwiseAbs().maxCoeff() + hit.t < farthest_))
    return std::nullopt;
  WallPoint met{ray.origin + hit.t * ray.direction, wall.normal};
  if (!walls_.visit(hit.surface, [&](const auto& each) { return is_clear(each, wall, met); }))
    return std::nullopt;
  if (!(std::fabs(met.normal.dot(ray.direction)) > kLeastCosine)) return std::nullopt;
  return met;
}

bool OffsetOrigins::is_clear(const Segment&, const Wall& wall, const WallPoint& met) const {
  const double place = along(wall.normal).dot(met.point - wall.at);
  for (std::uint32_t i = wall.begin; i < wall.end; ++i)
    if (stretches_[i].low <= place && place <= stretches_[i].high) return false;
  return true;
}

// It sets the normal.
bool OffsetOrigins::is_clear(const Arc& arc, const Wall& wall, WallPoint& met) const {
  const Vec2 normal = normal_near(arc, met.point);
  met.normal = normal / std::sqrt(normal.x() * normal.x() + normal.y() * normal.y());
  const bool whole = arc.extent == Arc::Extent::whole;
  return (whole || ends_far(arc.from, arc.to, met.point)) && others_far(wall, met.point);
}

// As does this: upright on the curve where that is as far along the chord.
bool OffsetOrigins::is_clear(const Bezier& curve, const Wall& wall, WallPoint& met) const {
  const double place = wall.normal.dot(met.point - wall.at);
  const auto beyond = bernstein_of(
      kPlain, curve, [&](const Vec2& p) { return wall.normal.dot(p - wall.at) - place; });
  if (!(beyond.front() < 0 && beyond.back() > 0)) return false;
  const Vec2 tangent =
      tangent_at(curve, sign_change([&](double s) { return bernstein_value(beyond, s); }, 0, 1));
  met.normal = Vec2(-tangent.y(), tangent.x()) / std::sqrt(tangent.squaredNorm());
  return ends_far(curve.start(), curve.end(), met.point) && others_far(wall, met.point);
}

bool OffsetOrigins::others_far(const Wall& wall, const Vec2& point) const {
  return std::all_of(near_.begin() + wall.begin, near_.begin() + wall.end, [&](std::uint32_t i) {
    return table_[i].is_plain &&
           walls_.visit(i, [&](const auto& other) { return is_far(other, table_[i], point); });
  });
}

}  // namespace flatray
