#pragma once
#include "trace/cells.h"

namespace flatray {

/// The cells with walls that a ray comes through, in order, in double precision: the walk of
/// kernels/walk_body.h for one ray.
class CellWalk {
 public:
  /// Needs   `grid` to outlive it; a direction that is not zero.
  CellWalk(const CellGrid& grid, const Ray& ray);
  /// Whether it is too far away, or of a direction beyond sound arithmetic: any wall may be met.
  bool is_uncertain() const { return uncertain_; }

  /// Goes on to the next cell with walls; false beyond the last.
  bool next();
  /// The first record of the cell.
  std::size_t record() const { return record_; }
  /// Hits surely later than this, in lengths of the ray's direction, are in cells to come as well.
  double limit() const { return limit_; }

 private:
  void enter();

  const CellGrid& grid_;
  CellGrid::Turn turn_;
  // In cells, turned so that the ray goes up and to the right; step_ is of unit length.
  Vec2 origin_, step_, inverse_;
  Vec2 place_, corner_, exit_;  // where the cell is entered; of it; planes its box is left by
  double begin_ = 0;  // t of origin_, which is on the border of the grid for rays from beyond it
  double exit_t_ = 0, length_ = 1, limit_ = 0;
  std::size_t record_ = 0;
  bool uncertain_ = false, entered_ = false, outside_ = false, empty_ = false;
};

}  // namespace flatray
