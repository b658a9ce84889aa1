#pragma once
#include <string>

#include "base/result.h"
#include "base/source_text.h"
#include "scene/scene.h"

namespace flatray {

/// The paper's tables 4 and 5 (box against box) recomputed beside what is printed there.
///
/// Needs   a scene with the paper's two boxes, as scenes/paper/case_two.toml has them.
/// Error   one without, Trouble::usage at `where`.
Result<std::string> paper_table(const Scene& scene, const Place& where);

}  // namespace flatray
