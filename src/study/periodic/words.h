#pragma once
#include "study/periodic/closed_orbits.h"

namespace flatray {

/// Words of `length` walls that closed orbits may have, each once among those that differ in where
/// they begin: no straight wall and no disc follows itself. None repeats a shorter one, but where
/// orbits of it need not: where a wall is bounced off from inside, and of straight walls twice an
/// odd number of them.
///
/// Cost    nullopt where there are more than `most`.
std::optional<std::vector<Word>> words(const std::vector<Mirror>& mirrors, std::size_t length,
                                       std::size_t most);

/// The closed orbits of all words of 1 to `length` walls, by length, then word. The same whatever
/// `threads`; stopped() of the monitor is asked between words.
///
/// Error   too many words; a stopped run.
Result<std::vector<ClosedOrbit>> orbits_by_word(const ExperimentContext& context,
                                                const MirrorRoom& room, std::size_t length);

}  // namespace flatray
