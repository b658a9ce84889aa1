#pragma once
#include "study/periodic/unfolded.h"

namespace flatray {

/// What is known of the closed orbits of a word.
enum class Verdict : std::uint8_t {
  proven,     ///< it is there; between discs and straight walls it is the only one of its word
  family,     ///< there are parallel ones, between straight walls alone
  pruned,     ///< there is proven to be none
  undecided,  ///< it runs so near to an end or along a wall that doubles cannot tell
  not_found   ///< none was found, which proves nothing
};
std::string_view name_of(Verdict verdict);

struct ClosedOrbit {
  Word word;
  Verdict verdict = Verdict::not_found;
  std::string why{};  ///< of what is none, or undecided
  Near length{0.0};   ///< where it is proven or of a family, as is what follows
  Near trace{0.0};    ///< of the matrix that takes what is across it once around
  std::vector<Vec2> points{};
  std::size_t number = 1;  ///< of those of its word, as they are found

  bool is_there() const { return verdict == Verdict::proven || verdict == Verdict::family; }
  /// The eigenvalue larger in size; nullopt where both have size 1, or where that is open.
  std::optional<Near> eigenvalue() const;
};

/// The closed orbits of a word.
///
/// Gives   of a word of straight walls alone, or of discs and straight walls, one answer. Where a
///         wall is bounced off from inside, every orbit that Newton's method comes to from 48
///         draws, of a word that is a power those that are no repeats.
/// Source  docs/NUMERICS.md, periodic orbits.
std::vector<ClosedOrbit> closed_orbits(const MirrorRoom& room, const Word& word);

/// The same, of straight walls alone: by exact fractions, but for what stands in the way.
ClosedOrbit straight_orbit(const MirrorRoom& room, const Word& word);
/// The same, of discs, one at least, and straight walls.
ClosedOrbit disc_orbit(const MirrorRoom& room, const Word& word);
/// Whether every closed polygon of the word's walls is ruled out, by ever smaller boxes of places
/// along curves: nowhere is its length stationary, or it runs past an end, or a wall is in its way.
/// Words in which a curve follows itself at once are not looked at.
bool is_ruled_out(const MirrorRoom& room, const Word& word);
/// The same, of any walls.
std::vector<ClosedOrbit> drawn_orbits(const MirrorRoom& room, const Word& word);

/// The way along a straight line that straight walls, one after the other, bring back to itself;
/// all lines along it are such, or only one, that leads through a point.
struct ReturningLine {
  Pair<Near> way;
  std::optional<Pair<Near>> through;
};
/// nullopt where there is none.
std::optional<ReturningLine> returning_line(const MirrorRoom& room, const Word& straight);
/// Whether the same walls, or others, take a line to the same image. Exact.
bool have_same_image(const MirrorRoom& room, const Word& straight, const Word& other);

}  // namespace flatray
