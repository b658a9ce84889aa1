#include "oracle/long_orbit.h"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geom/pair.h"

namespace flatray::oracle {
namespace {

using Long = mpf_class;

using LongPoint = Pair<Long>;

// mpf's own conversion cuts off.
double nearest(const Long& x) {
  if (sgn(x) == 0) return 0;
  const double low = x.get_d();
  const double high = std::nextafter(low, sgn(x) * std::numeric_limits<double>::infinity());
  const Long beyond = abs(x - low), to_next = abs(high - x);
  const int order = cmp(beyond, to_next);
  if (order != 0) return order > 0 ? high : low;
  return std::fmod(low / std::fabs(high - low), 2) == 0 ? low : high;
}

LongPoint left_of(const LongPoint& v) { return {-v.y, v.x}; }

// Where the line of the way meets a wall.
struct Met {
  Long t;
  bool at_end = false;
  Long s{};  // of a Bezier curve, its parameter
};

class Walker {
 public:
  Walker(const Surfaces& walls, const Ray& start, unsigned bits,
         std::span<const Material> materials)
      : walls_(walls),
        materials_(materials.begin(), materials.end()),
        bits_(bits),
        point_(place(start.origin)),
        way_(place(start.direction)),
        soon_(number(std::ldexp(1.0, -static_cast<int>(bits / 4 < 1000 ? bits / 4 : 1000)))),
        small_(number(std::ldexp(1.0, -static_cast<int>(bits / 2 < 1000 ? bits / 2 : 1000)))) {
    materials_.resize(walls.size(), Material::mirror);
    LongPoint sum = place({0, 0});
    for (std::uint32_t i = 0; i < walls.size(); ++i)
      if (materials_[i] == Material::periodic) {
        cell_.push_back(i);
        sum = sum + place(walls.segment(i).a);
      }
    if (!cell_.empty()) middle_ = number(1) / static_cast<unsigned>(cell_.size()) * sum;
  }

  // The next wall that is not crossed, without what becomes of the way there.
  std::optional<LongOrbit::Bounce> next() {
    constexpr int kMostCrossings = 1 << 18;
    std::optional<LongPoint> entry;  // where the first wall crossed led
    for (int crossings = 0; crossings < kMostCrossings; ++crossings) {
      const auto first = first_met();
      if (!first) return std::nullopt;
      point_ = point_ + first->t * way_;
      if (first->crossed) {
        point_ = point_ + shift(first->surface);
        if (entry && is_small(point_ - *entry)) return std::nullopt;
        if (!entry) entry = point_;
        continue;
      }
      const Vec2 point(nearest(point_.x), nearest(point_.y));
      const LongPoint beyond = point_ - place(point);
      return LongOrbit::Bounce{
          first->surface, point, {nearest(beyond.x), nearest(beyond.y)}, first->corner};
    }
    return std::nullopt;
  }

  void turn(std::uint32_t surface) {
    const LongPoint normal =
        left_of(walls_.visit(surface, [&](const auto& wall) { return direction_of(wall); }));
    const Long twice = 2 * dot(way_, normal) / dot(normal, normal);
    way_ = way_ - twice * normal;
  }

 private:
  struct First {
    Long t;
    std::uint32_t surface;
    bool corner, crossed;  // crossed: all that are met there are periodic
  };
  std::optional<First> first_met() const {
    std::optional<First> first;
    for (std::uint32_t i = 0; i < walls_.size(); ++i) {
      const bool periodic = materials_[i] == Material::periodic;
      if (periodic && !leads_out(walls_.segment(i))) continue;
      for (const Met& met : walls_.visit(i, [&](const auto& wall) { return times(wall); })) {
        if (periodic ? met.t < -soon_ : met.t <= soon_) continue;
        const Long beyond = first ? Long(met.t - first->t) : Long(-1);
        if (first && beyond > small_ * abs(first->t) + small_) continue;
        const bool together = first && abs(beyond) <= small_ * abs(first->t) + small_;
        if (!together) {
          first = First{met.t, i, met.at_end && !is_hole(i), periodic};
          continue;
        }
        if (is_hole(first->surface)) continue;
        if (is_hole(i)) {  // its ends with it
          first = First{first->t, i, false, false};
          continue;
        }
        first->corner |= met.at_end || first->surface != i;
        first->crossed &= periodic;
      }
    }
    return first;
  }

  bool is_hole(std::uint32_t surface) const { return materials_[surface] == Material::hole; }

  bool leads_out(const Segment& wall) const {
    const LongPoint edge = direction_of(wall);
    const Long inward = cross(edge, middle_ - place(wall.a)), turn = cross(edge, way_);
    return sgn(turn) != 0 && sgn(turn) != sgn(inward);
  }
  // From a wall of the cell to that opposite.
  LongPoint shift(std::uint32_t surface) const {
    const auto at = std::find(cell_.begin(), cell_.end(), surface) - cell_.begin();
    const auto count = cell_.size();
    const auto far = cell_[(static_cast<std::size_t>(at) + count / 2) % count];
    return place(walls_.segment(far).b) - place(walls_.segment(surface).a);
  }
  bool is_small(const LongPoint& v) const { return abs(v.x) <= small_ && abs(v.y) <= small_; }

  Long number(double x) const { return {x, bits_}; }
  LongPoint place(const Vec2& v) const { return {number(v.x()), number(v.y())}; }

  std::vector<Met> times(const Segment& wall) const {
    return times_between(place(wall.a), place(wall.b));
  }
  std::vector<Met> times_between(const LongPoint& a, const LongPoint& b) const {
    const LongPoint along = b - a, to = a - point_;
    const Long across = cross(way_, along), size = dot(way_, way_);
    if (across * across <= small_ * small_ * size * dot(along, along)) {
      const Long beside = cross(to, way_);
      if (beside * beside > small_ * small_ * size * (1 + dot(to, to))) return {};
      return {{dot(to, way_) / size, true}, {dot(b - point_, way_) / size, true}};
    }
    const Long part = cross(to, way_) / across;
    if (part < -small_ || part > 1 + small_) return {};
    return {{cross(to, along) / across, part <= small_ || part >= 1 - small_}};
  }

  // A point is touched at most, and what is touched is passed by.
  std::vector<Met> times(const Arc& arc) const {
    if (sgn(cross(place(arc.curve.u), place(arc.curve.v))) == 0) return {};
    const LongPoint from = in_circle(arc.curve, point_ - place(arc.curve.centre));
    const LongPoint way = in_circle(arc.curve, way_);
    const Long a = dot(way, way), b = dot(way, from);
    const Long quarter = b * b - a * (dot(from, from) - 1);
    std::vector<Met> times = joints(arc);
    if (quarter <= small_ * a) return times;
    const Long root = sqrt(quarter);
    for (const Long& t : {Long((-b - root) / a), Long((root - b) / a)})
      if (const auto at_end = end_of(arc, point_ + t * way_)) times.push_back({t, *at_end});
    return times;
  }
  // What joins ends that are not on the curve to it.
  std::vector<Met> joints(const Arc& arc) const {
    std::vector<Met> met;
    if (arc.extent != Arc::Extent::between) return met;
    const LongPoint centre = place(arc.curve.centre);
    for (const Vec2& end : {arc.from, arc.to}) {
      const LongPoint to = place(end) - centre, form = in_circle(arc.curve, to);
      const Long size = sqrt(dot(form, form));
      if (abs(size - 1) <= small_) continue;
      for (const Met& one : times_between(place(end), centre + 1 / size * to))
        met.push_back({one.t, true});
    }
    return met;
  }

  // Between places where what is beside the way changes its sign.
  std::vector<Met> times(const Bezier& wall) const {
    constexpr int kParts = 256;
    const auto beside = [&](const Long& s) { return cross(way_, point_at(wall, s) - point_); };
    const Long size = dot(way_, way_);
    std::vector<Met> found;
    const auto add = [&](const Long& s, bool at_end) {
      found.push_back({dot(way_, point_at(wall, s) - point_) / size, at_end, s});
    };
    for (const int end : {0, 1})
      if (abs(beside(number(end))) <= small_ * size) add(number(end), true);
    for (int i = 0; i < kParts; ++i) {
      Long low = number(i) / kParts, high = number(i + 1) / kParts;
      const int from = sgn(beside(low));
      if (from == 0 || from == sgn(beside(high))) continue;
      for (mp_bitcnt_t halvings = 0; halvings < std::min<mp_bitcnt_t>(bits_, 60); ++halvings) {
        const Long middle = (low + high) / 2;
        (sgn(beside(middle)) == from ? low : high) = middle;
      }
      for (mp_bitcnt_t right = 32; right < bits_; right *= 2)  // by Newton's rule
        high -= beside(high) / cross(way_, rate_at(wall, high));
      if (high > small_ && high < 1 - small_) add(high, false);
    }
    return found;
  }
  // By de Casteljau's rule: what is left of points when `most` are.
  static std::vector<LongPoint> divided(std::vector<LongPoint> points, const Long& s,
                                        std::size_t most) {
    for (; points.size() > most; points.pop_back())
      for (std::size_t k = 0; k + 1 < points.size(); ++k)
        points[k] = points[k] + s * (points[k + 1] - points[k]);
    return points;
  }
  std::vector<LongPoint> points_of(const Bezier& wall) const {
    std::vector<LongPoint> points;
    for (int k = 0; k <= wall.degree; ++k) points.push_back(place(wall.point(k)));
    return points;
  }
  LongPoint point_at(const Bezier& wall, const Long& s) const {
    if (!wall.is_weighted()) return divided(points_of(wall), s, 1)[0];
    const Long r = 1 - s, first = r * r, middle = 2 * r * s * number(wall.weight), last = s * s;
    return quotient(weighted(wall, first, middle, last), first + middle + last);
  }
  LongPoint weighted(const Bezier& wall, const Long& first, const Long& middle,
                     const Long& last) const {
    const std::vector<LongPoint> p = points_of(wall);
    return first * p[0] + middle * p[1] + last * p[2];
  }
  static LongPoint quotient(const LongPoint& v, const Long& by) { return {v.x / by, v.y / by}; }
  // Of a weighted curve by the quotient's rule, with n = point whole: whole point' = n' - whole' point.
  LongPoint rate_at(const Bezier& wall, const Long& s) const {
    if (wall.is_weighted()) {
      const Long w = number(wall.weight), r = 1 - s;
      const Long first = -2 * r, middle = 2 * w * (r - s), last = 2 * s;
      const Long whole = r * r + 2 * r * s * w + s * s, rise = first + middle + last;
      return quotient(weighted(wall, first, middle, last) - rise * point_at(wall, s), whole);
    }
    const std::vector<LongPoint> chord = divided(points_of(wall), s, 2);
    return number(wall.degree) * (chord[1] - chord[0]);
  }

  // Parts of the half-diameters that a vector is the sum of, by Cramer's rule.
  LongPoint in_circle(const Ellipse& curve, const LongPoint& w) const {
    const LongPoint u = place(curve.u), v = place(curve.v);
    const Long whole = cross(u, v);
    return {cross(w, v) / whole, cross(u, w) / whole};
  }

  // Whether a point of the curve of an arc on it is an end; nullopt of one that is not on it.
  std::optional<bool> end_of(const Arc& arc, const LongPoint& point) const {
    if (arc.extent == Arc::Extent::whole) return false;
    const LongPoint to = point - place(arc.curve.centre);
    if (arc.extent == Arc::Extent::half) return sign_of_end(dot(to, place(arc.from)));
    const LongPoint centre = place(arc.curve.centre), from = place(arc.from) - centre,
                    last = place(arc.to) - centre;
    const auto begun = sign_of_end(cross(from, to)), open = sign_of_end(cross(to, last));
    const bool reflex = sgn(cross(from, last)) < 0;
    if (reflex ? !begun && !open : !begun || !open) return std::nullopt;
    return (begun.value_or(false) && dot(from, to) > 0) ||
           (open.value_or(false) && dot(last, to) > 0);
  }
  // Of what is negative outside: whether it is 0.
  std::optional<bool> sign_of_end(const Long& x) const {
    return x < -small_ ? std::nullopt : std::optional(x <= small_);
  }

  // A wall's direction at the point.
  LongPoint direction_of(const Segment& wall) const { return place(wall.b) - place(wall.a); }
  LongPoint direction_of(const Arc& arc) const {
    const Ellipse& curve = arc.curve;
    const LongPoint at = in_circle(curve, point_ - place(curve.centre));
    return at.x * place(curve.v) - at.y * place(curve.u);
  }
  LongPoint direction_of(const Bezier& wall) const {
    const std::vector<Met> all = times(wall);
    const auto here = std::min_element(
        all.begin(), all.end(), [](const Met& a, const Met& b) { return abs(a.t) < abs(b.t); });
    return rate_at(wall, here->s);
  }

  const Surfaces& walls_;
  std::vector<Material> materials_;
  std::vector<std::uint32_t> cell_;  // its walls, in order
  mp_bitcnt_t bits_;
  LongPoint point_, way_;
  LongPoint middle_;  // of the cell
  Long soon_;         // what is met before is the wall just left
  Long small_;        // what is 0
};

}  // namespace

LongOrbit long_orbit(const Surfaces& walls, const Ray& start, std::uint64_t bounces, unsigned bits,
                     std::span<const Material> materials) {
  LongOrbit orbit;
  Walker walker(walls, start, bits, materials);
  while (orbit.bounces.size() < bounces) {
    const auto next = walker.next();
    if (!next) {
      orbit.end = LongOrbit::End::escape;
      break;
    }
    orbit.bounces.push_back(*next);
    const Material met = materials.empty() ? Material::mirror : materials[next->surface];
    if (met == Material::absorb || met == Material::hole) {
      orbit.end = LongOrbit::End::absorbed;
      break;
    }
    walker.turn(next->surface);
  }
  return orbit;
}

}  // namespace flatray::oracle
