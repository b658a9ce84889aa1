#include "collide/turning_pair.h"

#include <algorithm>

namespace flatray {
namespace {

// Of each number some twenty roundings of what its terms add up to, sines and cosines of 1 ulp and
// angles of some ulps: docs/NUMERICS.md.
constexpr double kRoundings = 0x1p-47, kLeastError = 0x1p-900;
// Radians from which on the disc in which a body turns is looked at.
constexpr double kManyTurns = 64;

double largest(const Cubic<Vec2>& way, double length) {
  double most = 0, factor = 1;
  for (const Vec2& p : way.c) {
    most = std::max(most, factor * p.cwiseAbs().maxCoeff());
    factor *= length;
  }
  return most;
}

// A power of two that brings what is added up to about 1.
double scale_of(const TurningBody& a, const TurningBody& b, double length) {
  double most = largest(b.motion.at - a.motion.at, length);
  for (const TurningBody* body : {&a, &b}) {
    most = std::max(most, body->radius);
    for (const Vec2& p : body->ring) most = std::max(most, p.cwiseAbs().maxCoeff());
    for (const Swing& swing : body->motion.swings)
      most = std::max(most, largest(swing.arm, length));
  }
  constexpr int kMost = 1000;
  if (!(most > 0 && most < kInfinity)) return 1;
  return std::ldexp(1.0, -std::clamp(std::ilogb(most), -kMost, kMost));
}

}  // namespace

TurningPair::TurningPair(const TurningBody& a, const TurningBody& b, double length, bool backwards)
    : length_(length),
      backwards_(backwards),
      scale_(scale_of(a, b, length)),
      a_(a, scale_, length),
      b_(b, scale_, length),
      way_(scale_ * (b.motion.at - a.motion.at)),
      radii_(a_.radius + b_.radius),
      speed_(kUp * way_.sum_of_slope(length) + a_.swing_speed + b_.swing_speed),
      bend_(kUp * way_.most_bend(length) + a_.swing_bend + b_.swing_bend) {
  const double swings =
      static_cast<double>(a.motion.swings.size()) + static_cast<double>(b.motion.swings.size());
  const double turns = 1 + swings + a_.widest_angle + b_.widest_angle;
  const double farthest = kUp * way_.sum(length) + a_.swung + b_.swung;
  const double size = farthest + a_.reach + b_.reach + radii_;
  const double given = kUp * (scale_ * (a.motion.doubt + b.motion.doubt) +
                              a.motion.angle_doubt * a_.reach + b.motion.angle_doubt * b_.reach);
  const auto errors = [&](double angles, double spins, double curve) -> Errors {
    return {kRoundings * angles * size + given + kLeastError,
            kRoundings * angles * (speed_ + spins * size) + kLeastError, curve};
  };
  // How the slope of a gap to the other's centre may change, seen by who turns with `frame`.
  const auto carried = [&](const TurnedBody& frame) {
    const double w = frame.most_spin;
    return kUp * ((w * w + frame.most_turn) * farthest + 2 * w * speed_) + bend_;
  };
  const Cubic<double> turn = b_.angle - a_.angle;
  const double relative = turn.most_slope(length), turning = turn.most_bend(length);
  const double spins = a_.most_spin + b_.most_spin;
  const auto seen_by = [&](const TurnedBody& frame, const TurnedBody& other) {
    return errors(turns, spins,
                  carried(frame) + kUp * (relative * relative + turning) * other.reach);
  };
  // How often the other turns does not matter to the disc about it, but for what its swings do.
  const bool any_swings = a_.swung > 0 || b_.swung > 0;
  const auto disc_seen_by = [&](const TurnedBody& frame) {
    return any_swings ? errors(turns, spins, carried(frame))
                      : errors(1 + frame.widest_angle, frame.most_spin, carried(frame));
  };
  const auto own = [](const TurnedBody& body) {
    return (body.most_spin * body.most_spin + body.most_turn) * body.reach;
  };
  by_a_ = seen_by(a_, b_);
  by_b_ = seen_by(b_, a_);
  still_ = errors(turns, spins, kUp * (own(a_) + own(b_)) + bend_);
  disc_by_a_ = disc_seen_by(a_);
  disc_by_b_ = disc_seen_by(b_);
}

// How long gap + slope t - curve t^2 / 2 certainly stays positive.
double TurningPair::positive_for(double gap, double slope, const Errors& errors) const {
  const auto& [gap_error, slope_error, curve] = errors;
  const double least = gap - gap_error, rise = (backwards_ ? -slope : slope) - slope_error;
  if (!(least > 0)) return 0;
  const double root = std::sqrt(rise * rise + 2 * curve * least);
  if (rise < 0) return kDown * (2 * least / (root - rise));
  return curve > 0 ? kDown * ((root + rise) / curve) : kInfinity;
}

// The distance of two points in straight motion is convex: only how they leave it counts.
double TurningPair::apart_by_centres() const {
  const Vec2 from = b_.centre - a_.centre;
  const double distance = size_of(from);
  if (!(distance > 0)) return 0;
  return positive_for(distance - kUp * (a_.reach + b_.reach + radii_),
                      dot(from, b_.velocity - a_.velocity) / distance,
                      {still_.gap_error, still_.slope_error, bend_});
}

// How long all vertices of the other stay beyond an edge of `frame`, or else some of them behind it, as
// seen by who turns with `frame`; `enough` ends the search.
template <bool kApart>
double TurningPair::holds_by_edge(const TurnedBody& frame, std::size_t edge,
                                  const TurnedBody& other, const Errors& errors,
                                  double enough) const {
  const Vec2 &normal = frame.normals[edge], &start = frame.points[edge];
  double time = kApart ? kInfinity : 0;
  for (std::size_t k = 0; k < other.points.size() && !(kApart && time <= enough); ++k) {
    const Vec2& p = other.points[k];
    const double gap = dot(normal, p - start);
    const double slope = dot(normal, other.moves(k) - frame.carries(p));
    time = kApart ? std::min(time, positive_for(gap - radii_, slope, errors))
                  : std::max(time, positive_for(-gap, -slope, errors));
  }
  return time;
}

// How long the disc in which the other turns stays beyond an edge.
double TurningPair::apart_by_disc(const TurnedBody& frame, std::size_t edge,
                                  const TurnedBody& other, const Errors& errors) const {
  const Vec2& normal = frame.normals[edge];
  const double gap = dot(normal, other.centre - frame.points[edge]);
  return positive_for(gap - (radii_ + kUp * other.reach),
                      dot(normal, other.velocity - frame.carries(other.centre)), errors);
}

// Along the line between the two nearest vertices, as the world sees it.
double TurningPair::apart_by_vertices() const {
  Vec2 from(0, 0);
  double nearest = kInfinity;
  for (const Vec2& p : a_.points)
    for (const Vec2& q : b_.points)
      if (const double distance = size_of(q - p); distance < nearest) {
        nearest = distance;
        from = q - p;
      }
  if (!(nearest > 0)) return 0;
  return holds_along(from / nearest, true);
}

double TurningPair::holds_along(const Vec2& normal, bool apart) const {
  double time = apart ? kInfinity : 0;
  for (std::size_t i = 0; i < a_.points.size(); ++i)
    for (std::size_t k = 0; k < b_.points.size() && time > (apart ? 0 : -1); ++k) {
      const double gap = dot(normal, b_.points[k] - a_.points[i]) - radii_;
      const double slope = dot(normal, b_.moves(k) - a_.moves(i));
      time = apart ? std::min(time, positive_for(gap, slope, still_))
                   : std::max(time, positive_for(-gap, -slope, still_));
    }
  return time;
}

double TurningPair::apart_for(double enough) const {
  double best = apart_by_centres();
  const auto look = [&](const TurnedBody& frame, const TurnedBody& other, bool as_disc,
                        const Errors& errors) {
    for (std::size_t i = 0; best < enough && i < frame.normals.size(); ++i)
      best = std::max(best, as_disc ? apart_by_disc(frame, i, other, errors)
                                    : holds_by_edge<true>(frame, i, other, errors, best));
  };
  if (b_.most_spin * length_ > kManyTurns) look(a_, b_, true, disc_by_a_);
  if (a_.most_spin * length_ > kManyTurns) look(b_, a_, true, disc_by_b_);
  look(a_, b_, false, by_a_);
  look(b_, a_, false, by_b_);
  const bool edges_tell = radii_ == 0 && std::max(a_.points.size(), b_.points.size()) > 2;
  if (best < enough && !edges_tell) best = std::max(best, apart_by_vertices());
  return best;
}

double TurningPair::vertex_distance(const TurnedBody& vertices, const TurnedBody& edges) const {
  double least = kInfinity;
  for (std::size_t i = 0; i < edges.points.size(); ++i) {
    const Vec2& start = edges.points[i];
    const Vec2 along = edges.points[i + 1 == edges.points.size() ? 0 : i + 1] - start;
    const double squared = dot(along, along);
    for (const Vec2& p : vertices.points) {
      const double part = squared > 0 ? std::clamp(dot(p - start, along) / squared, 0.0, 1.0) : 0.0;
      least = std::min(least, size_of(p - start - part * along));
    }
  }
  return least;
}

// How long for each edge some vertex of the other stays behind it.
double TurningPair::across_for(const TurnedBody& frame, const TurnedBody& other,
                               const Errors& errors) const {
  double least = kInfinity;
  for (std::size_t i = 0; i < frame.normals.size() && least > 0; ++i)
    least = std::min(least, holds_by_edge<false>(frame, i, other, errors, 0));
  return least;
}

// Separating axes of two convex cores are across their edges.
double TurningPair::overlap_for() const {
  double longest = 0;
  if (!a_.normals.empty() || !b_.normals.empty())
    longest = std::min(across_for(a_, b_, by_a_), across_for(b_, a_, by_b_));
  if (radii_ == 0) return longest;
  const double distance = std::min(vertex_distance(a_, b_), vertex_distance(b_, a_));
  const double speed =
      kUp * (speed_ + a_.most_spin * a_.reach + b_.most_spin * b_.reach) + still_.slope_error;
  return std::max(longest, kDown * (radii_ - distance - still_.gap_error) / speed);
}

Bounds TurningPair::box_of(const TurnedBody& body) const {
  Bounds box;
  const Vec2 reach(body.radius, body.radius);
  for (const Vec2& p : body.points) box.add(Bounds{(p - reach) / scale_, (p + reach) / scale_});
  return box;
}

ContactPlace TurningPair::touching_place() const {
  return resting_place({a_.points, {0, 0}, a_.radius}, {b_.points, {0, 0}, b_.radius}, 0);
}

}  // namespace flatray
