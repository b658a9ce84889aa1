#pragma once
#include "scene/load.h"
#include "scene/reading/scene_desc.h"

namespace flatray {

/// Puts `-D key=value` into a description: keys that are not there are made, array entries are
/// chosen by number from 0 or by their name.
///
/// Error   at a place called "-D key", or as it is said; see tell_where_said. Unknown keys are found
///         when the scene is built.
Result<void> apply_override(SceneDesc& desc, const Override& override_value);

/// Whether a place lies in an override.
bool is_override(const Place& place);

/// Makes mistakes in overrides Trouble::usage, at their places in the file that says them, if one does.
void tell_where_said(Diagnostics& problems);

/// The place of what an override put into a value; `otherwise` where nothing in it is from one.
Place place_of_change(const Value& value, const Place& otherwise);

}  // namespace flatray
