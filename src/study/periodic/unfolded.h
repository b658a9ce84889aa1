#pragma once
#include "study/periodic/stationary.h"

namespace flatray {

/// A word by its bounces off curved walls, each with what comes before the next of them.
struct Unfolded {
  /// A disc that is left out, as it is seen from the bounce before.
  struct Passed {
    Circle disc;
    Isometry<Near> seen;
  };
  struct Leg {
    Word straight;               ///< walls in order
    std::vector<Passed> passed;  ///< discs in order
  };
  std::vector<CurvedBounce> bounces;
  std::vector<Leg> legs;
};

/// Needs   at least one place of a curved wall in `kept`, ascending.
Unfolded unfold(const MirrorRoom& room, const Word& word, const std::vector<std::size_t>& kept);

/// The places of a word's curved walls.
std::vector<std::size_t> curved_places(const MirrorRoom& room, const Word& word);

/// What is proven of a closed polygon that obeys the law of reflection.
struct Judged {
  /// Bounces off curved walls are on the side from which orbits come, and no straight line.
  Proof reflects = Proof::yes;
  /// The rest: it bounces between the ends of each wall, in order, and nothing is in its way.
  Proof clear = Proof::yes;
  std::string why{};  ///< what is not so, or open, of the first such
  Near length{0.0}, trace{0.0};
  std::vector<Vec2> points{};  ///< by bounce

  void note(Proof& of, Proof found, const std::string& words) {
    if (found != Proof::yes && (why.empty() || found == Proof::no)) why = words;
    of = of & found;
  }
};

/// Follows straight walls of a word from a chord's beginning: `way` leads to the last point,
/// unfolded.
void follow_straight(const MirrorRoom& room, const Chord& ends, Pair<Near> way,
                     const Word& straight, Judged& judged);

/// Needs   a polygon whose places are known, proven or within a box: what is said holds for all of
///         it.
/// Source  of the trace: S. Tabachnikov, Geometry and Billiards (2005), chapter 5: free flights and
///         reflections as matrices of two rows, each reflection with the sign -1.
Judged judge(const MirrorRoom& room, const Word& word, const StationaryPolygon& polygon,
             const std::vector<Unfolded::Leg>& legs);

}  // namespace flatray
