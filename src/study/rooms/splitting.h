#pragma once
#include "study/rooms/room.h"

namespace flatray {

/// How a room is looked at by splitting.
struct SplittingPlan {
  std::uint64_t orbits;  ///< of each group, at every level
  std::uint64_t levels;
  std::uint64_t bounces;  ///< from a level to the next
  std::uint64_t first;    ///< of the two levels whose ways are kept; the other is the last
  double apart;           ///< radians by which clones are turned, at most
};

/// What one group of orbits comes to.
struct SplitGroup {
  std::vector<double> share;        ///< estimate of what is left, by level from the first on
  std::vector<double> first, last;  ///< ways of the orbits left at the plan's two levels
  double ancestors = 0;             ///< of its orbits, of which those of the last level come

  Numbers numbers() const;
  static SplitGroup from(std::span<const double> numbers);
};

/// An orbit of a group, where it stands.
struct Walker {
  OrbitStart at;
  double way = 0;  ///< up to there
  std::size_t ancestor = 0;
};

/// The side of its wall on which a start stands.
Sign side_of_start(const Room& room, const OrbitStart& start);

/// A group of orbits from level to level: first starts by the measure that reflection keeps. Those
/// that are left at a level are drawn from with repetition, as many as at first, and each of these
/// is turned by a random angle at the wall where it stands, as a clone that sets off alike stays
/// alike for ever.
class Population {
 public:
  /// Needs   the context, room and plan to outlive it.
  Population(const ExperimentContext& context, const Room& room, const SplittingPlan& plan,
             std::uint64_t group);
  /// Follows all to the next level, and keeps those that are left.
  void advance();
  /// Needs   some that are left.
  void clone();
  const std::vector<Walker>& walkers() const { return walkers_; }

 private:
  const ExperimentContext& context_;
  const Room& room_;
  const SplittingPlan& plan_;
  std::uint64_t group_;
  std::uint32_t level_ = 0;  // clones made
  std::vector<Walker> walkers_;
};

/// What a population comes to.
///
/// Gives   shares whose mean over many groups is what is left of all orbits, but for what turning
///         by `apart` changes, which grows with its square.
/// Source  fixed splitting with a fixed number of orbits: Kahn and Harris 1951; unbiased, as Del
///         Moral (Feynman-Kac Formulae, 2004, theorem 7.4.2) has it.
SplitGroup split_group(const ExperimentContext& context, const Room& room,
                       const SplittingPlan& plan, std::uint64_t group);

}  // namespace flatray
