#pragma once
#include "study/periodic/closed_orbits.h"

namespace flatray {

/// A motion or reflection that takes every mirror of a room to one.
struct Symmetry {
  Word to;      ///< by mirror
  bool turned;  ///< whether it is a reflection
};

/// Those that a room has but for rounding (10^-9 of its size), that which moves nothing first; of a
/// room with ellipses, or all of whose walls have one middle, that alone.
std::vector<Symmetry> symmetries(const MirrorRoom& room);

/// Whether no two of them take every mirror to the same.
bool are_told_apart(const std::vector<Symmetry>& all);

/// The word that a symmetry makes of it.
Word taken(const Word& word, const Symmetry& by);
/// The least of a word as read from any of its places.
Word least_turn(const Word& word);
/// How many words, told apart wherever they begin, the symmetries make of it.
std::size_t words_alike(const Word& word, const std::vector<Symmetry>& all);

/// A closed orbit in a room of which what symmetries make alike is one: after `symbols` bounces it
/// is where a symmetry takes its beginning, and after `parts` times as many where it began.
struct ReducedWord {
  Word word;  ///< the whole of it, one of those alike
  std::size_t symbols, parts;
  bool turned;  ///< of that symmetry
};

/// All of `symbols` bounces that are no repeats, each once. Needs mirrors of which none follows
/// itself.
///
/// Gives   nullopt where one is taken to itself, place by place, by a symmetry that moves walls: it
///         lies on an axis, and counts otherwise.
std::optional<std::vector<ReducedWord>> reduced_words(const std::vector<Symmetry>& all,
                                                      std::size_t mirrors, std::size_t symbols);

}  // namespace flatray
