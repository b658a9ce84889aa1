#pragma once
#include <cstdint>
#include <string>

#include "base/source_text.h"
#include "geom/ellipse.h"

namespace flatray {

/// What a ray does on arrival.
enum class Material {
  absorb,
  mirror,
  glass,    ///< reflects or refracts, by chance
  hole,     ///< of a chamber's walls: it leaves the room, at the ends of the hole too
  periodic  ///< of a chamber that is an upright box: who leaves by one wall enters by that opposite
};

/// Part of an edge of a chamber by which rays leave, its ends with it: shares of the edge's length, of an
/// ellipse of its parameter.
struct WallHole {
  std::string name;
  std::int32_t edge = 0;
  double from = 0, to = 0;
  Place where;
};

/// What an edge is cut into by its holes.
struct WallPiece {
  PathWall wall;
  std::int32_t edge;
  std::uint32_t hole;   ///< of the chamber; kNoEntry: of none
  bool turned = false;  ///< the edge as given runs the other way
};

}  // namespace flatray
