#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/isa.h"
#include "collide/contact.h"
#include "collide/kernels/pairs.h"

namespace flatray {

/// Convex bodies made ready for many contacts.
///
/// Needs   cores as clip_convex does, radii not negative.
/// Cost    some 560 bytes a body; making one ready is linear in its vertices.
class BodySet {
 public:
  /// The number of the body.
  std::uint32_t add(std::span<const Vec2> core, double radius = 0);
  std::size_t size() const { return radii_.size(); }
  MovingBody body(std::uint32_t number, const Vec2& velocity) const {
    const std::size_t begin = begin_[number];
    return {std::span(vertices_).subspan(begin, begin_[number + 1] - begin), velocity,
            radii_[number]};
  }

  /// What tells at first sight that a body is far away.
  struct Box {
    Vec2 centre;
    Vec2 half;  ///< not below the distance of any point of the body from it along each axis
  };
  std::span<const Box> boxes() const { return boxes_; }

  /// A polygon as the lanes need it.
  struct Ready {
    pairs::Outline lanes;
    int count;  ///< of corners
    /// Counter-clockwise without repeated vertices, the last also before and the first also after
    /// them; their numbers in the ring, and the ring's edge from each to the next.
    std::array<Vec2, pairs::kCorners + 2> around;
    std::array<std::int32_t, pairs::kCorners> numbers, edges;

    const Vec2& corner(int k) const { return around[static_cast<std::size_t>(k) + 1]; }
  };
  /// Whether lanes can tell anything of it: a polygon of few corners, without a radius.
  bool is_ready(std::uint32_t body) const { return is_ready_[body] != 0; }
  const Ready& ready(std::uint32_t body) const { return ready_[body]; }

 private:
  std::vector<Vec2> vertices_;
  std::vector<std::size_t> begin_{0};
  std::vector<double> radii_;
  std::vector<Box> boxes_;
  std::vector<std::uint8_t> is_ready_;
  std::vector<Ready> ready_;
};

/// Two bodies of a set, and how they move.
struct MovingPair {
  std::uint32_t a, b;
  Vec2 velocity_a, velocity_b;
};

/// What contact() gives for each pair, bit for bit, whatever the tier.
///
/// Needs   as many `contacts` as pairs.
/// Cost    in a range that begins at 0 some 10 ns a pair that stays apart; some 30 ns for polygons with
///         area of up to eight vertices; others as contact() does.
void contacts(const BodySet& bodies, std::span<const MovingPair> pairs, Range within,
              std::span<Contact> contacts, Isa isa = active_isa());

}  // namespace flatray
