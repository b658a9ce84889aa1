#pragma once
#include "base/json.h"

namespace flatray {

/// JSON Schema (draft 7) of the scene language, made of the tables that read it: keys, what they
/// take, defaults. It holds every scene that the program takes to be valid, and tells unknown keys,
/// missing keys and values of the wrong kind; what needs arithmetic (a box without area, a row that
/// does not sum to 1) it lets pass.
JsonValue scene_schema();

}  // namespace flatray
