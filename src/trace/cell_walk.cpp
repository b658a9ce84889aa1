#include "trace/cell_walk.h"

#include <algorithm>
#include <cmath>

namespace flatray {

CellWalk::CellWalk(const CellGrid& grid, const Ray& ray) : grid_(grid) {
  origin_ = grid.place(ray.origin);
  const Vec2 along = ray.direction.cwiseProduct(grid.scale());
  const double square = along.squaredNorm(), far = grid.view().far;
  if (!(square > lanes::kLeastSquare && square < lanes::kLargestSquare &&
        std::fabs(origin_.x()) < far && std::fabs(origin_.y()) < far)) {
    uncertain_ = outside_ = true;
    return;
  }
  length_ = std::sqrt(square);
  turn_ = {along.x() < 0, along.y() < 0};
  step_ = (along / length_).cwiseAbs().cwiseMax(lanes::kLeastStep);
  inverse_ = step_.cwiseInverse();
  origin_ = turn_(origin_);
  const Vec2 half = grid.half();
  if (std::fabs(origin_.x()) > half.x() || std::fabs(origin_.y()) > half.y()) {
    const double into = std::max(0.0, (-half - origin_).cwiseQuotient(step_).maxCoeff());
    const double out = (half - origin_).cwiseQuotient(step_).minCoeff();
    if (out < into) {
      outside_ = true;
      return;
    }
    begin_ = into;
    origin_ = (origin_ + into * step_).cwiseMax(-half).cwiseMin(half);
  }
  place_ = origin_;
}

void CellWalk::enter() {
  const CellGrid::Cell cell = grid_.cell_at(place_, turn_);
  empty_ = (cell.word >> 31) != 0;
  const int quadrant = (turn_.x ? 1 : 0) + (turn_.y ? 2 : 0);
  const double cells = empty_ ? cell.word >> (7 * quadrant) & 127U : 1;
  record_ = cell.word;
  outside_ = cells == 0;
  corner_ = cell.corner;
  exit_ = corner_ + cells * Vec2(cell.side, cell.side);
  exit_t_ = (exit_ - origin_).cwiseProduct(inverse_).minCoeff();
  limit_ = (begin_ + exit_t_ - lanes::kNear * grid_.unit()) / length_;
}

bool CellWalk::next() {
  while (!outside_) {
    if (entered_) {
      const Vec2 t = (exit_ - origin_).cwiseProduct(inverse_);
      const int across = t.x() < t.y() ? 0 : 1;
      place_ = (origin_ + exit_t_ * step_).cwiseMax(corner_);
      place_[across] = exit_[across];
    }
    entered_ = true;
    enter();
    if (!outside_ && !empty_) return true;
  }
  return false;
}

}  // namespace flatray
