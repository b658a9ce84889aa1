#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "flatray/trace.h"

/// When moving convex bodies meet, and until when. Every answer is decided exactly for the doubles
/// given, and is the same on every machine.
namespace flatray::api {

/// Two bodies by their numbers, and how they move: each point is at place + t * velocity.
struct MovingPair {
  std::uint32_t a, b;
  double velocity_ax, velocity_ay, velocity_bx, velocity_by;
};

/// What of two bodies meets: an edge of one, a vertex of the other.
struct ContactFeature {
  bool edge_of_a = true;
  std::int32_t edge = kNoEdge;    ///< from this vertex to the next; kNoEdge: none, or not told
  std::int32_t vertex = kNoEdge;  ///< of the other

  bool operator==(const ContactFeature&) const = default;
};

/// When two closed bodies have a point in common.
struct Contact {
  double first = 1, last = 0;  ///< to 1 ulp; first > last exactly where `kind` is none
  /// touch: for one instant, or without a common inner point for no time; along: they touch for a
  /// while; through: they overlap.
  HitClass kind = HitClass::none;
  StartPlace start = StartPlace::outside;  ///< at t = 0: apart, touching or overlapping
  bool first_overflows = false,
       last_overflows = false;  ///< that t lies beyond the doubles, given as the largest
  ContactFeature at_first{},
      at_last{};  ///< where those lie within the range, but for two vertices that are rounded

  bool operator==(const Contact&) const = default;
};

/// Convex bodies made ready for any number of contacts, numbered from 0 as they are added: all points
/// within `radius` of a convex polygon, a segment or a point. A disc is a point with a radius, a
/// capsule a segment with one.
///
/// Owns    copies of all that is added. Moved from, it is empty.
/// Threads one at a time while something is added or it is moved; any number may ask one object at
///         once. A call starts none of its own.
class Bodies {
 public:
  Bodies();
  Bodies(Bodies&&) noexcept;
  Bodies& operator=(Bodies&&) noexcept;
  ~Bodies();

  /// A convex polygon, in either orientation.
  ///
  /// Error   `sizes`, `not_finite`, `empty`, `not_convex`: the entry is the vertex; `radius`, `full`.
  /// Cost    linear in its vertices; some 550 bytes.
  Status add_polygon(std::span<const double> x, std::span<const double> y, double radius = 0);
  /// Discs, one an entry. Error   `sizes`, `not_finite`, `radius`, `full`.
  Status add_discs(std::span<const double> x, std::span<const double> y,
                   std::span<const double> radius);
  std::size_t size() const;

  /// The first and the last instant at which each pair meets, within a range of t.
  ///
  /// Needs   as many contacts as pairs.
  /// Gives   pairs without relative motion are the whole range what they are at the start.
  /// Error   `sizes`, `no_such`, `not_finite`: the entry is the pair.
  /// Cost    in a range from 0 on some 30 ns a pair that stays apart and, without radii, of up to eight
  ///         vertices, 200 ns of one that meets; else some us.
  Status contacts(std::span<const MovingPair> pairs, Range within,
                  std::span<Contact> contacts) const;

 private:
  struct Data;
  Owned<Data> data_;
};

}  // namespace flatray::api
