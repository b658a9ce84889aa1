#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "flatray/trace.h"

/// When moving convex bodies begin to meet, and when they part. Every answer is decided exactly for
/// the doubles given, and is the same on every machine.
namespace flatray::api {

/// Two bodies by their numbers, and how they move: at t each point has moved by t * velocity.
struct MovingPair {
  std::uint32_t a, b;
  double velocity_ax, velocity_ay, velocity_bx, velocity_by;
};

/// Which parts of two bodies meet: an edge of one and a vertex of the other.
struct ContactFeature {
  bool edge_of_a = true;
  /// From this vertex to the next, 0 where the body has no area; kNoEdge: none, or not told.
  std::int32_t edge = kNoEdge;
  std::int32_t vertex = kNoEdge;  ///< of the other

  bool operator==(const ContactFeature&) const = default;
};

/// When two closed bodies have a point in common.
struct Contact {
  double first = 1, last = 0;  ///< nearest doubles; first > last exactly where `kind` is none
  /// touch: they touch for one instant, or, where neither moves as seen from the other, all the
  /// time; along: they touch for a while, without a common inner point; through: they overlap.
  HitClass kind = HitClass::none;
  StartPlace start = StartPlace::outside;  ///< at t = 0: apart, touching or overlapping
  bool first_overflows = false,
       last_overflows = false;  ///< that t lies beyond the doubles and is given as the largest
  /// What meets then; kNoEdge where that t is an end of the range, and of two vertices, rounded or in line.
  ContactFeature at_first{}, at_last{};

  bool operator==(const Contact&) const = default;
};

/// Convex bodies made ready for any number of contacts, numbered from 0 in the order in which they
/// are added. A body is all points within `radius` of a convex polygon, a segment or a point: a
/// disc is a point with a radius, a capsule a segment with one.
///
/// Owns    copies of all that is added. Once moved from, it is empty.
/// Threads one alone while bodies are added or it is moved; else any number at once. A call starts
///         no thread.
class Bodies {
 public:
  Bodies();
  Bodies(Bodies&&) noexcept;
  Bodies& operator=(Bodies&&) noexcept;
  ~Bodies();

  /// All points within `radius` of a convex polygon, given in either orientation.
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
  /// Gives   of a pair without relative motion how it lies at the start, for the whole range.
  /// Error   `sizes`, `no_such`, `not_finite`: the entry is the pair.
  /// Cost    in a range from 0 on some 30 ns for a pair that stays apart, and 200 ns for one that
  ///         meets, without radii and with up to eight vertices; else some us.
  Status contacts(std::span<const MovingPair> pairs, Range within,
                  std::span<Contact> contacts) const;

 private:
  struct Data;
  Owned<Data> data_;
};

}  // namespace flatray::api
