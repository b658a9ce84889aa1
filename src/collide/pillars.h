#pragma once
#include "base/result.h"
#include "scene/scene.h"

namespace flatray {

/// Whether the pillars of a scene's chamber stand in it, in frame 1, and apart, as far as contact
/// tells; a disc may stand across periodic walls, as its copies stand there too, where it is no larger in
/// radius than the cell is deep. Curved walls of the chamber, and arcs but those of capsules and ellipses, are not
/// looked at.
///
/// Error   the first that does not.
Result<void> expect_pillars_inside(const Scene& scene);
Result<void> expect_pillars_apart(const Scene& scene);

}  // namespace flatray
