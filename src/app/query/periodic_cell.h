#pragma once
#include "app/query/question.h"
#include "scene/scene.h"

namespace flatray {

/// The walls of an orbit question, and how its answer numbers them.
struct QuestionRoom {
  Surfaces walls;  ///< those asked about; then the edges of the cell, then copies of discs
  std::vector<Material> materials;     ///< by surface
  std::vector<std::uint32_t> numbers;  ///< by surface: of a copy that of its disc
};

/// Walls as they stand: all mirrors.
QuestionRoom plain_room(Surfaces walls);

/// Walls inside a cell of which opposite edges are the same: "cell":[[x,y],...], four or six
/// corners. A whole circle that stands across its edges is copied to where it reaches in from other
/// cells.
///
/// Gives   mistakes of the question where the polygon is no such cell, counter-clockwise; where a
///         wall reaches out of it, for curves that are no whole circles by their box; where a disc
///         reaches farther than the copies that are made, or stands where another's copy does.
///         Exact, but for the box.
QuestionRoom periodic_room(Question& question, Surfaces walls);

/// Whether a point is in its cell or on the edge of it; without a cell all are. Exact.
bool is_in_cell(const QuestionRoom& room, const Vec2& point);

}  // namespace flatray
