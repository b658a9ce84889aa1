#pragma once
#include <optional>

#include "collide/contact_batch.h"

namespace flatray {

/// The contact of a pair for t in [0, length], from the edges a kernel has guessed.
///
/// Needs   shapes that are ready, in relative motion; length > 0.
/// Gives   what contact() does; nullopt where the guess is not proven right, or an end of the range
///         is met exactly.
/// Source  an edge of the Minkowski difference is one where the neighbours of the vertex that meets
///         it lie beyond that vertex; the origin comes in by it where its ends are on the left and
///         right of its way. Four predicates prove an edge, whoever found it.
std::optional<Contact> certain_contact(const PolygonSet& shapes, const MovingPair& pair,
                                       double length, const sweep::Guess& guess);

}  // namespace flatray
