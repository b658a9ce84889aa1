#pragma once
#include <string>

#include "study/periodic/numbered_words.h"

namespace flatray {

/// Angles in radians, and parts of lengths: far more than what they lose by rounding.
inline constexpr double kRough = 1e-12;

/// The part of a disc on which a bounce is: within so many radians of a direction from the centre,
/// near length 1.
struct BounceArc {
  Circle disc{};
  Vec2 at{1, 0};
  double off = 0;
};

/// Discs of which every word that does not name one twice in turn has one orbit: whole ones, and
/// neither another disc is near the way between two nor anything else.
///
/// Source  of that: T. Morita, Trans. Amer. Math. Soc. 325 (1991) 819.
class OpenDiscs {
 public:
  /// Error   why they are not known to be such.
  static tl::expected<OpenDiscs, std::string> of(const MirrorRoom& room);

  std::size_t size() const { return all_.size(); }
  const Circle& operator[](std::size_t i) const { return all_[i]; }

  /// Where a bounce of a word is.
  const BounceArc& arc(const Word& word, std::size_t at) const;

 private:
  // Where a bounce is that so many others come before and after.
  struct Arcs {
    NumberedWords words;
    std::size_t before;
    std::vector<BounceArc> arcs{};
  };

  OpenDiscs() = default;
  bool is_apart(std::size_t i, std::size_t j, std::size_t k) const;
  Vec2 both_ways(std::size_t before, std::size_t at, std::size_t after) const;
  bool middle_is_known(std::size_t before, std::size_t at, std::size_t after) const;
  bool are_beside(const Surfaces& walls, std::uint32_t surface) const;
  void find_arcs();
  void narrow_together(Arcs& level) const;
  Arcs with_fewer(const Arcs& known, bool at_front) const;

  std::vector<Circle> all_;
  std::size_t most_ = 0;    // bounces that are looked at before and after one
  std::vector<Arcs> arcs_;  // by how many come before, then after
};

}  // namespace flatray
