#pragma once
#include <cmath>
#include <vector>

#include "collide/turning_contact.h"

namespace flatray {

// A body as it is at one time, seen from where the first is.
class TurnedBody {
 public:
  TurnedBody(const TurningBody& body, double scale);

  void place(const Vec2& at, const Vec2& moving, double time);

  double widest_angle(double length) const { return std::fabs(angle_) + std::fabs(spin) * length; }
  Vec2 moves(std::size_t vertex) const {
    return velocity + spin * Vec2(-arms[vertex].y(), arms[vertex].x());
  }
  // How a point would move that turned with the body.
  Vec2 carries(const Vec2& point) const {
    return velocity + spin * Vec2(centre.y() - point.y(), point.x() - centre.x());
  }

  const double radius, spin;
  double reach = 0;  ///< of the core
  Vec2 centre{0, 0}, velocity{0, 0};
  std::vector<Vec2> points, normals, arms;  ///< arms: points from the centre

 private:
  const double angle_;
  std::vector<Vec2> local_, local_normals_;
};

// Two bodies at a time, and what is certain of them then.
class TurningPair {
 public:
  TurningPair(const TurningBody& a, const TurningBody& b, double length, bool backwards);

  void place(double now) {
    const double time = backwards_ ? length_ - now : now;
    a_.place({0, 0}, {0, 0}, time);
    b_.place(apart_ + time * way_, way_, time);
  }
  // For how long from then on they are apart; `enough` ends the search.
  double apart_for(double enough) const;
  bool overlap() const;
  // For how long from then on they overlap.
  double overlap_for() const;
  RoundPlace touching_place() const;
  double scale() const { return scale_; }

 private:
  // What a gap and its slope are off by, and how its slope may change.
  struct Bounds {
    double gap_error, slope_error, curve;
  };
  Bounds disc_bounds(const TurnedBody& frame, double size, double farthest, double speed) const;
  double positive_for(double gap, double slope, const Bounds& bounds) const;
  double positive_for(double gap, double slope, double curve) const {
    return positive_for(gap, slope, {gap_error_, slope_error_, curve});
  }
  double apart_by_centres() const;
  double apart_by_disc(const TurnedBody& frame, const TurnedBody& other,
                       const Bounds& bounds) const;
  double apart_by_edges(const TurnedBody& frame, const TurnedBody& other, double curve,
                        double at_least) const;
  double apart_by_vertices() const;
  bool across_all_edges(const TurnedBody& frame, const TurnedBody& other) const;
  double across_for(const TurnedBody& frame, const TurnedBody& other, double curve) const;
  double vertex_distance(const TurnedBody& vertices, const TurnedBody& edges) const;

  const double length_;
  const bool backwards_;
  const double scale_;
  TurnedBody a_, b_;
  const Vec2 apart_, way_;
  const double radii_;
  double gap_error_, slope_error_, curve_a_, curve_b_, curve_still_;
  Bounds disc_of_b_, disc_of_a_;  ///< seen from the other
};

}  // namespace flatray
