#include "trace/cell_walk.h"

#include <algorithm>
#include <cmath>

namespace flatray {
namespace {

double at_least_a_step(double x) {
  return std::fabs(x) < lanes::kLeastStep ? std::copysign(lanes::kLeastStep, x) : x;
}

}  // namespace

CellWalk::CellWalk(const CellGrid& grid, const Ray& ray) : grid_(grid) {
  origin_ = grid.place(ray.origin);
  const Vec2 along = ray.direction.cwiseProduct(grid.scale());
  const double square = along.squaredNorm(), far = grid.view().far;
  if (!(square > lanes::kLeastSquare && square < lanes::kLargestSquare &&
        std::fabs(origin_.x()) < far && std::fabs(origin_.y()) < far)) {
    start_ = Start::uncertain;
    return;
  }
  length_ = std::sqrt(square);
  direction_ = (along / length_).unaryExpr(&at_least_a_step);
  inverse_ = direction_.cwiseInverse();
  const Vec2 half = grid.half();
  if (std::fabs(origin_.x()) > half.x() || std::fabs(origin_.y()) > half.y()) {
    const Vec2 side(std::copysign(half.x(), direction_.x()),
                    std::copysign(half.y(), direction_.y()));
    const double into = std::max(0.0, (-side - origin_).cwiseQuotient(direction_).maxCoeff());
    const double out = (side - origin_).cwiseQuotient(direction_).minCoeff();
    if (out < into) {
      start_ = Start::misses;
      return;
    }
    begin_ = into;
    origin_ = (origin_ + into * direction_).cwiseMax(-half).cwiseMin(half);
  }
  corner_ = Vec2(std::floor(origin_.x()), std::floor(origin_.y()));
}

void CellWalk::enter() {
  const std::uint32_t word = grid_.word(corner_.x(), corner_.y());
  empty_ = (word >> 31) != 0;
  const int quadrant = (direction_.x() < 0 ? 1 : 0) + (direction_.y() < 0 ? 2 : 0);
  const double side = empty_ ? word >> (7 * quadrant) & 127U : 1;
  record_ = word;
  outside_ = side == 0;
  for (int axis = 0; axis < 2; ++axis)
    exit_[axis] = corner_[axis] + (direction_[axis] < 0 ? 1 - side : side);
  exit_t_ = (exit_ - origin_).cwiseProduct(inverse_).minCoeff();
  limit_ = (begin_ + exit_t_ - lanes::kNear * grid_.unit()) / length_;
}

bool CellWalk::next() {
  if (start_ != Start::walks) return false;
  for (;;) {
    if (entered_) {
      const Vec2 t = (exit_ - origin_).cwiseProduct(inverse_);
      const int across = t.x() < t.y() ? 0 : 1, aside = 1 - across;
      const double back = direction_[across] < 0 ? 1 : 0;
      const double last = exit_[aside] - (direction_[aside] < 0 ? 0 : 1);
      const double place = std::floor(origin_[aside] + exit_t_ * direction_[aside]);
      corner_[aside] =
          std::clamp(place, std::min(corner_[aside], last), std::max(corner_[aside], last));
      corner_[across] = exit_[across] - back;
    }
    entered_ = true;
    enter();
    if (outside_) return false;
    if (!empty_) return true;
  }
}

}  // namespace flatray
