#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "anim/responses.h"
#include "collide/simulate.h"

namespace flatray {

/// A part of each of two bodies, and where they touch.
struct Touch {
  IndexPair pair;
  std::uint32_t part_a, part_b;
  ContactPlace place;

  bool is_of_parts(const Touch& other) const {
    return pair == other.pair && part_a == other.part_a && part_b == other.part_b;
  }
};

/// When two bodies meet, from when they are seen, and all places where they do at that time, with different
/// normals.
struct Hit {
  double time;
  IndexPair pair;
  std::vector<Touch> touches{};
};

/// What becomes of two that lie in each other, or touch, at once.
enum class Overlap : std::uint8_t {
  meets,
  glides,  ///< parts that come nearer so gently do not meet
  passed   ///< not at all, as long as it is so
};

/// Whether b comes nearer to a against a normal out of a.
bool approach(const Vec2& normal, const Vec2& a, const Vec2& b);
/// Whether it comes nearer by no more than kSlideLeaves of the larger speed, if at all: normals are rounded.
bool is_gentle(const Vec2& normal, const Vec2& a, const Vec2& b);

/// Pairs of bodies, each on the last of its stages.
class BodyPairs {
 public:
  /// Needs   both to outlive it.
  BodyPairs(std::span<const SimulatedBody> bodies, const std::vector<std::vector<Stage>>& stages);

  double radius(std::uint32_t body) const { return radii_[body]; }
  Vec2 place(std::uint32_t body, double time) const;

  /// Whether they have inner points in common at a time.
  bool overlap(const IndexPair& pair, double time) const;
  /// A time from `time` on before which they do not meet; none where they never do before `end`.
  std::optional<double> least_wait(const IndexPair& pair, double time, double end) const;
  /// When they meet, as seen from `time`. Two that lie in each other meet at once, where they come nearer
  /// along the shortest way out; or as `overlap` says.
  std::optional<Hit> meeting(const IndexPair& pair, double time, double end, Overlap overlap) const;
  /// Whether two parts that have touched with this normal, and not parted along it since, would meet with
  /// that normal again.
  bool face(const Touch& touch, double time) const;

 private:
  MovingBody part(std::uint32_t body, std::uint32_t part, const Vec2& at,
                  std::vector<Vec2>& ring) const;
  template <class Look>
  void each_contact(const IndexPair& pair, double time, Range within, const Look& look) const;

  const std::span<const SimulatedBody> bodies_;
  const std::vector<std::vector<Stage>>& stages_;
  std::vector<double> radii_;
};

}  // namespace flatray
