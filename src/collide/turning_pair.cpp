#include "collide/turning_pair.h"

#include <algorithm>

#include "base/portable_math.h"
#include "geom/polygon.h"

namespace flatray {
namespace {

// Of each number some twenty roundings of what its terms add up to, sines and cosines of 1 ulp and
// angles of some ulps: docs/NUMERICS.md.
constexpr double kRoundings = 0x1p-47, kLeast = 0x1p-900;
// Radians from which on the disc in which a body turns is looked at.
constexpr double kManyTurns = 64;
constexpr double kUp = 1 + 0x1p-40, kDown = 1 - 0x1p-40;

double dot(const Vec2& p, const Vec2& q) { return p.x() * q.x() + p.y() * q.y(); }
double length_of(const Vec2& v) { return std::sqrt(dot(v, v)); }

// A power of two that brings what is added up to about 1.
double scale_of(const TurningBody& a, const TurningBody& b, double length) {
  double most = std::max((b.at - a.at).cwiseAbs().maxCoeff(),
                         length * (b.velocity - a.velocity).cwiseAbs().maxCoeff());
  for (const TurningBody* body : {&a, &b}) {
    most = std::max(most, body->radius);
    for (const Vec2& p : body->ring) most = std::max(most, p.cwiseAbs().maxCoeff());
  }
  constexpr int kMost = 1000;
  if (!(most > 0 && most < kInfinity)) return 1;
  return std::ldexp(1.0, -std::clamp(std::ilogb(most), -kMost, kMost));
}

}  // namespace

TurnedBody::TurnedBody(const TurningBody& body, double scale)
    : radius(scale * body.radius), spin(body.spin), angle_(body.angle) {
  for (const std::uint32_t i : turned_ring(body.ring, ring_orientation(body.ring)))
    local_.push_back(scale * body.ring[i]);
  for (std::size_t i = 0; local_.size() > 1 && i < local_.size(); ++i) {
    const Vec2 along = local_[i + 1 == local_.size() ? 0 : i + 1] - local_[i];
    local_normals_.push_back(Vec2(along.y(), -along.x()).stableNormalized());
  }
  for (const Vec2& p : local_) reach = std::max(reach, kUp * length_of(p));
  arms.resize(local_.size());
  points.resize(local_.size());
  normals.resize(local_normals_.size());
}

void TurnedBody::place(const Vec2& at, const Vec2& moving, double time) {
  const double angle = angle_ + time * spin;
  const double c = portable::cos(angle), s = portable::sin(angle);
  const auto turn = [c, s](const Vec2& p) {
    return Vec2(c * p.x() - s * p.y(), s * p.x() + c * p.y());
  };
  centre = at;
  velocity = moving;
  for (std::size_t i = 0; i < local_.size(); ++i) {
    arms[i] = turn(local_[i]);
    points[i] = at + arms[i];
  }
  for (std::size_t i = 0; i < normals.size(); ++i) normals[i] = turn(local_normals_[i]);
}

TurningPair::TurningPair(const TurningBody& a, const TurningBody& b, double length, bool backwards)
    : length_(length),
      backwards_(backwards),
      scale_(scale_of(a, b, length)),
      a_(a, scale_),
      b_(b, scale_),
      apart_(scale_ * (b.at - a.at)),
      way_(scale_ * (b.velocity - a.velocity)),
      radii_(a_.radius + b_.radius) {
  const double turns = 1 + a_.widest_angle(length) + b_.widest_angle(length);
  const double speed = kUp * length_of(way_), spins = std::fabs(a.spin) + std::fabs(b.spin);
  const double farthest = kUp * (length_of(apart_) + length * speed);
  const double size = farthest + a_.reach + b_.reach + radii_;
  gap_error_ = kRoundings * turns * size + kLeast;
  slope_error_ = kRoundings * turns * (speed + spins * size) + kLeast;
  const auto curve = [&](const TurnedBody& frame, const TurnedBody& other) {
    const double w = std::fabs(frame.spin), relative = std::fabs(other.spin - frame.spin);
    return kUp * (w * w * farthest + 2 * w * speed + relative * relative * other.reach);
  };
  curve_a_ = curve(a_, b_);
  curve_b_ = curve(b_, a_);
  curve_still_ = kUp * (a.spin * a.spin * a_.reach + b.spin * b.spin * b_.reach);
  disc_of_b_ = disc_bounds(a_, size, farthest, speed);
  disc_of_a_ = disc_bounds(b_, size, farthest, speed);
}

// How often the other turns does not matter to the disc about it.
TurningPair::Bounds TurningPair::disc_bounds(const TurnedBody& frame, double size, double farthest,
                                             double speed) const {
  const double w = std::fabs(frame.spin), turns = 1 + frame.widest_angle(length_);
  return {kRoundings * turns * size + kLeast, kRoundings * turns * (speed + w * size) + kLeast,
          kUp * (w * w * farthest + 2 * w * speed)};
}

// How long gap + slope t - curve t^2 / 2 certainly stays positive.
double TurningPair::positive_for(double gap, double slope, const Bounds& bounds) const {
  const auto& [gap_error, slope_error, curve] = bounds;
  const double least = gap - gap_error, rise = (backwards_ ? -slope : slope) - slope_error;
  if (!(least > 0)) return 0;
  const double root = std::sqrt(rise * rise + 2 * curve * least);
  if (rise < 0) return kDown * (2 * least / (root - rise));
  return curve > 0 ? kDown * ((root + rise) / curve) : kInfinity;
}

// The distance of two points in straight motion is convex: no curve counts.
double TurningPair::apart_by_centres() const {
  const Vec2 from = b_.centre - a_.centre;
  const double distance = length_of(from);
  if (!(distance > 0)) return 0;
  return positive_for(distance - kUp * (a_.reach + b_.reach + radii_), dot(from, way_) / distance,
                      0);
}

// The gap between an edge of `frame` and the disc in which the other turns.
double TurningPair::apart_by_disc(const TurnedBody& frame, const TurnedBody& other,
                                  const Bounds& bounds) const {
  double best = 0;
  for (std::size_t i = 0; i < frame.normals.size(); ++i) {
    const Vec2& normal = frame.normals[i];
    const double gap = dot(normal, other.centre - frame.points[i]) - (radii_ + kUp * other.reach);
    if (gap > bounds.gap_error)
      best = std::max(
          best,
          positive_for(gap, dot(normal, other.velocity - frame.carries(other.centre)), bounds));
  }
  return best;
}

// The gaps between edges of `frame` and the other body, as seen by who turns with `frame`. More than
// `at_least`, or 0.
double TurningPair::apart_by_edges(const TurnedBody& frame, const TurnedBody& other, double curve,
                                   double at_least) const {
  double best = 0;
  for (std::size_t i = 0; i < frame.normals.size(); ++i) {
    const Vec2 &normal = frame.normals[i], &on_edge = frame.points[i];
    double least = kInfinity;
    for (std::size_t k = 0; k < other.points.size() && least > at_least; ++k) {
      const Vec2& p = other.points[k];
      const double gap = dot(normal, p - on_edge) - radii_;
      if (gap <= gap_error_)
        least = 0;
      else
        least = std::min(least,
                         positive_for(gap, dot(normal, other.moves(k) - frame.carries(p)), curve));
    }
    if (least > at_least) best = at_least = least;
  }
  return best;
}

// Along the line between the two nearest vertices, as the world sees it.
double TurningPair::apart_by_vertices() const {
  Vec2 from(0, 0);
  double nearest = kInfinity;
  for (const Vec2& p : a_.points)
    for (const Vec2& q : b_.points)
      if (const double distance = length_of(q - p); distance < nearest) {
        nearest = distance;
        from = q - p;
      }
  if (!(nearest > 0)) return 0;
  const Vec2 normal = from / nearest;
  double least = kInfinity;
  for (std::size_t i = 0; i < a_.points.size(); ++i)
    for (std::size_t k = 0; k < b_.points.size() && least > 0; ++k)
      least = std::min(least, positive_for(dot(normal, b_.points[k] - a_.points[i]) - radii_,
                                           dot(normal, b_.moves(k) - a_.moves(i)), curve_still_));
  return least;
}

double TurningPair::apart_for(double enough) const {
  double best = apart_by_centres();
  if (best < enough && std::fabs(b_.spin) * length_ > kManyTurns)
    best = std::max(best, apart_by_disc(a_, b_, disc_of_b_));
  if (best < enough && std::fabs(a_.spin) * length_ > kManyTurns)
    best = std::max(best, apart_by_disc(b_, a_, disc_of_a_));
  if (best < enough) best = std::max(best, apart_by_edges(a_, b_, curve_a_, best));
  if (best < enough) best = std::max(best, apart_by_edges(b_, a_, curve_b_, best));
  const bool edges_tell = radii_ == 0 && std::max(a_.points.size(), b_.points.size()) > 2;
  if (best < enough && !edges_tell) best = std::max(best, apart_by_vertices());
  return best;
}

// Whether some vertex of the other is certainly behind each edge.
bool TurningPair::across_all_edges(const TurnedBody& frame, const TurnedBody& other) const {
  for (std::size_t i = 0; i < frame.normals.size(); ++i)
    if (std::none_of(other.points.begin(), other.points.end(), [&](const Vec2& p) {
          return dot(frame.normals[i], p - frame.points[i]) < -gap_error_;
        }))
      return false;
  return true;
}

double TurningPair::vertex_distance(const TurnedBody& vertices, const TurnedBody& edges) const {
  double least = kInfinity;
  for (std::size_t i = 0; i < edges.points.size(); ++i) {
    const Vec2& start = edges.points[i];
    const Vec2 along = edges.points[i + 1 == edges.points.size() ? 0 : i + 1] - start;
    const double squared = dot(along, along);
    for (const Vec2& p : vertices.points) {
      const double part = squared > 0 ? std::clamp(dot(p - start, along) / squared, 0.0, 1.0) : 0.0;
      least = std::min(least, length_of(p - start - part * along));
    }
  }
  return least;
}

// Separating axes of two convex cores are across their edges.
bool TurningPair::overlap() const {
  const bool have_edges = !a_.normals.empty() || !b_.normals.empty();
  if (have_edges && across_all_edges(a_, b_) && across_all_edges(b_, a_)) return true;
  if (radii_ == 0) return false;
  return std::min(vertex_distance(a_, b_), vertex_distance(b_, a_)) < radii_ - gap_error_;
}

// How long for each edge some vertex of the other stays behind it.
double TurningPair::across_for(const TurnedBody& frame, const TurnedBody& other,
                               double curve) const {
  double least = kInfinity;
  for (std::size_t i = 0; i < frame.normals.size() && least > 0; ++i) {
    double longest = 0;
    for (std::size_t k = 0; k < other.points.size(); ++k) {
      const Vec2& p = other.points[k];
      const double gap = dot(frame.normals[i], p - frame.points[i]);
      const double slope = dot(frame.normals[i], other.moves(k) - frame.carries(p));
      longest = std::max(longest, positive_for(-gap, -slope, curve));
    }
    least = std::min(least, longest);
  }
  return least;
}

double TurningPair::overlap_for() const {
  double longest = 0;
  if (!a_.normals.empty() || !b_.normals.empty())
    longest = std::min(across_for(a_, b_, curve_a_), across_for(b_, a_, curve_b_));
  if (radii_ == 0) return longest;
  const double distance = std::min(vertex_distance(a_, b_), vertex_distance(b_, a_));
  const double speed =
      kUp * (length_of(way_) + std::fabs(a_.spin) * a_.reach + std::fabs(b_.spin) * b_.reach) +
      slope_error_;
  return std::max(longest, kDown * (radii_ - distance - gap_error_) / speed);
}

RoundPlace TurningPair::touching_place() const {
  return resting_place({{a_.points, {0, 0}}, a_.radius}, {{b_.points, {0, 0}}, b_.radius}, 0);
}

}  // namespace flatray
