#pragma once
#include <string>

#include "study/periodic/mirrors.h"

namespace flatray {

/// Discs of which every word that does not name one twice in turn has one orbit: whole ones, and none is near
/// another or the way between two others.
///
/// Source  of that: T. Morita, Trans. Amer. Math. Soc. 325 (1991) 819.
class OpenDiscs {
 public:
  /// Error   why they are not known to be such.
  static tl::expected<OpenDiscs, std::string> of(const MirrorRoom& room);

  std::size_t size() const { return all_.size(); }
  const Circle& operator[](std::size_t i) const { return all_[i]; }

  /// Of a bounce between bounces off two others: the direction of its place from the centre, were these at the
  /// centres; and how far from it, at most, that of any such bounce is, in radians.
  Vec2 middle(std::size_t before, std::size_t at, std::size_t after) const;
  double play(std::size_t before, std::size_t at, std::size_t after) const {
    return plays_[(before * size() + at) * size() + after];
  }

 private:
  OpenDiscs() = default;
  bool is_apart(std::size_t i, std::size_t j, std::size_t k) const;
  Vec2 both_ways(std::size_t before, std::size_t at, std::size_t after) const;
  bool middle_is_known(std::size_t before, std::size_t at, std::size_t after) const;
  void find_plays();
  double narrowed_play(std::size_t i, std::size_t j, std::size_t k) const;
  Range turned_ways(std::size_t i, std::size_t j, std::size_t k, std::size_t to) const;

  std::vector<Circle> all_;
  std::vector<double> plays_;
};

/// A leg of an orbit, and how many times as wide what is across an unstable orbit gets on it.
struct OrbitStep {
  Near length, stretch;
};

/// From the bounce in the middle of a word, the earlier of two, to the next: enclosures for every orbit that stays for
/// ever and has the word in its own. Errors fall as fast as neighbours part, with half the number of bounces.
///
/// Needs   four bounces or more, of discs that differ from the one before.
/// Gives   an infinite error where too little is known.
/// Source  docs/NUMERICS.md, periodic orbits.
OrbitStep middle_step(const OpenDiscs& discs, const Word& word);

}  // namespace flatray
