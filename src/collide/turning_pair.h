#pragma once
#include "collide/turned_body.h"
#include "geom/bounds.h"

namespace flatray {

// Two bodies at a time, and what is certain of them then.
class TurningPair {
 public:
  TurningPair(const TurningBody& a, const TurningBody& b, double length, bool backwards);

  void place(double now) {
    const double time = backwards_ ? length_ - now : now;
    a_.place({0, 0}, {0, 0}, time);
    b_.place(way_(time), way_.slope(time), time);
  }
  // For how long from then on they are apart; `enough` ends the search.
  double apart_for(double enough) const;
  // For how long from then on they overlap.
  double overlap_for() const;
  ContactPlace touching_place() const;
  double scale() const { return scale_; }

  // The same along one direction of the world alone: how long they are apart, or overlap.
  double holds_along(const Vec2& normal, bool apart) const;
  // About, as the world has them but for where the first would be without its swings.
  Bounds box_a() const { return box_of(a_); }
  Bounds box_b() const { return box_of(b_); }

 private:
  // What a gap and its slope are off by, and how its slope may change.
  struct Errors {
    double gap_error, slope_error, curve;
  };
  Bounds box_of(const TurnedBody& body) const;
  double positive_for(double gap, double slope, const Errors& errors) const;
  double apart_by_centres() const;
  template <bool kApart>
  double holds_by_edge(const TurnedBody& frame, std::size_t edge, const TurnedBody& other,
                       const Errors& errors, double enough) const;
  double apart_by_disc(const TurnedBody& frame, std::size_t edge, const TurnedBody& other,
                       const Errors& errors) const;
  double apart_by_vertices() const;
  double across_for(const TurnedBody& frame, const TurnedBody& other, const Errors& errors) const;
  double vertex_distance(const TurnedBody& vertices, const TurnedBody& edges) const;

  const double length_;
  const bool backwards_;
  const double scale_;
  TurnedBody a_, b_;
  const Cubic<Vec2> way_;  // from the first to the second
  const double radii_;
  const double speed_, bend_;     // at most, of the centres; how the speed changes
  Errors still_, by_a_, by_b_;    // as seen by the world, and by those who turn with a and b
  Errors disc_by_a_, disc_by_b_;  // of the disc in which the other turns
};

}  // namespace flatray
