#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "geom/vec.h"

namespace flatray {

/// Vertices, faces and lines of a Wavefront OBJ text, z dropped; what else it holds is only named.
/// Vertices count from 1, or from 0 in a file called .obj2d.
struct ObjText {
  std::vector<Vec2> vertices;
  struct Chains {                         ///< faces, or polylines
    std::vector<std::uint32_t> corners;   ///< numbers of vertices, from 0
    std::vector<std::uint32_t> begin{0};  ///< chain i is corners [begin[i], begin[i + 1])
    std::size_t size() const { return begin.size() - 1; }
  } faces, lines;
  std::vector<std::string> ignored;  ///< records passed over: "vt", "usemtl", each once, at most 8
};

/// Error   malformed numbers and indices, each with line and column; at most 20 are told.
/// Cost    one pass, about 100 MB a second.
Result<ObjText> parse_obj(const SourcePtr& source);

}  // namespace flatray
