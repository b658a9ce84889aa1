#pragma once
#include "app/report/report.h"
#include "base/result.h"
#include "scene/scene.h"

namespace flatray {

/// The paper's tables 4 and 5 (box against box) recomputed beside what is printed there, and the
/// hit time it has not.
///
/// Needs   a scene with the paper's two boxes, as scenes/paper/case_two.toml has them.
/// Error   one without, Trouble::usage at `where`.
Result<VerbOutput> paper_tables(const Scene& scene, const Place& where);

}  // namespace flatray
