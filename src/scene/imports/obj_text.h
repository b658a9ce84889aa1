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

/// The text is cut at line ends into chunks whose size does not depend on `threads`, nor does the
/// result.
/// Needs   less than 2^32 bytes.
/// Error   malformed numbers and indices, each with line and column; at most 20 are told: first
///         what is no number, in the order of the text, then what there is no vertex for.
/// Cost    one pass: docs/measured/obj.md.
Result<ObjText> parse_obj(const SourcePtr& source, unsigned threads = 1);

}  // namespace flatray
