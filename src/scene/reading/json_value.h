#pragma once
#include "scene/reading/scene_desc.h"

namespace flatray {

/// One JSON value (RFC 8259) from byte `begin` to byte `end` of a text, with the places of all its
/// parts. An object is a table, null a number written "null".
///
/// Error   the first mistake of syntax, with its place: also a name given twice in an object,
///         brackets nested more than 64 deep, more than 4 million values.
Result<Value> json_value(const SourcePtr& source, std::size_t begin, std::size_t end);

}  // namespace flatray
