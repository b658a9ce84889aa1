#pragma once
#include "anim/frame_state.h"
#include "render/coverage/stroke.h"
#include "render/film_transform.h"

namespace flatray {

/// Lines in turn as chains: where one begins at the very point the one before it ends, both are one
/// chain; one that comes back to its beginning is closed.
std::vector<Chain> chained(std::span<const Segment> lines);

/// Rings of edges in any order, each beginning where another ends, as closed chains.
/// Cost    O(n log n), O(n) where they come in turn.
std::vector<Chain> rings_of(std::span<const Segment> edges);

/// A path of arcs, and Bezier curves that follow one another, by chords with the curves' directions,
/// within half of kCapSagitta_px of them.
Chain chain_of(const ArcPath& film_path);
std::vector<Chain> chains_of(std::span<const Bezier> film_curves);

/// The dashes of a chain; all of it where it has more than 10^6 of them.
///
/// Units   film pixels. Needs   an even number of lengths >= 0, lines and gaps in turn, together
///         far more than the 2^-20 px by which points are told apart (add_dashes: 0.25 px).
/// Gives   a closed chain's last dash joined to its first where none ends there.
std::vector<Chain> dashed(const Chain& chain, std::span<const double> lengths, double offset);

}  // namespace flatray
