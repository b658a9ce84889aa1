#include "trace/single_walk.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace flatray {
namespace {

constexpr float kFar = 1e30F;

// Names as in kernels/walk_body.h, where each step is explained.
class Walk {
 public:
  Walk(const lanes::Grid& grid, const lanes::Walking& ray)
      : grid_(grid),
        side_(static_cast<float>(lanes::kSide) * grid.unit),
        time_(static_cast<float>(lanes::kTime) * grid.unit),
        near_(static_cast<float>(lanes::kNear) * grid.unit),
        ox_(*ray.ox),
        oy_(*ray.oy),
        dx_(*ray.dx),
        dy_(*ray.dy),
        inverse_x_(*ray.inverse_x),
        inverse_y_(*ray.inverse_y),
        left_(std::signbit(dx_)),
        down_(std::signbit(dy_)),
        from_x_(left_ ? -ox_ : ox_),
        from_y_(down_ ? -oy_ : oy_),
        quadrant_((left_ ? 7 : 0) + (down_ ? 14 : 0)) {
    if (ray.left_ax == nullptr) return;
    left_ax_ = *ray.left_ax;
    left_ay_ = *ray.left_ay;
    left_bx_ = *ray.left_bx;
  }

  int scan() {
    limit_ = __builtin_inff();
    if (ox_ >= static_cast<float>(-grid_.half_x)) test_all(0);  // else in the ring
    return verdict();
  }

  int run() {
    const float step_x = std::fabs(dx_), step_y = std::fabs(dy_);
    float x = from_x_, y = from_y_;
    for (;;) {
      const std::uint32_t word = look_up(x, y);
      const bool empty = (word >> 31) != 0;
      const float side = empty ? cell_ * static_cast<float>(word >> quadrant_ & 127U) : cell_;
      if (side == 0) return verdict();
      const float exit_x = x + side, exit_y = y + side;
      const float t_x = (exit_x - from_x_) * inverse_x_, t_y = (exit_y - from_y_) * inverse_y_;
      const float exit = std::min(t_x, t_y);
      limit_ = exit - near_;
      if (!empty) test_all(word);
      if (std::min(high_, other_) < limit_) return verdict();
      if (t_x < t_y) {
        x = exit_x;
        y = std::max(from_y_ + exit * step_y, y);
      } else {
        x = std::max(from_x_ + exit * step_x, x);
        y = exit_y;
      }
    }
  }

 private:
  static float floor(float x) {  // of what an int can hold
    const auto down = static_cast<float>(static_cast<int>(x));
    return down - (x < down ? 1.0F : 0.0F);
  }
  static float index(float at, bool turned, float all) { return turned ? all - 1 - at : at; }

  // The word of the cell at a place, which is moved to its corner.
  std::uint32_t look_up(float& x, float& y) {
    const float left = floor(x), low = floor(y);
    const float at = grid_.first + grid_.stride * index(low, down_, 0) + index(left, left_, 0);
    const std::uint32_t word = grid_.cells[static_cast<int>(at)];
    cell_ = 1;
    if ((word >> 30) == 1) return look_up_divided(word, left, low, x, y);
    x = left;
    y = low;
    return word;
  }
  std::uint32_t look_up_divided(std::uint32_t word, float left, float low, float& x, float& y) {
    const auto n = std::bit_cast<float>(word & 0x7f800000U);
    const float column = std::min(floor((x - left) * n), n - 1);
    const float row = std::min(floor((y - low) * n), n - 1);
    cell_ = 1 / n;
    x = left + column * cell_;
    y = low + row * cell_;
    const float at = index(row, down_, n) * n + index(column, left_, n);
    return grid_.cells[16 * (word & 0x7fffffU) + static_cast<std::uint32_t>(at)];
  }

  void test_all(std::uint32_t record) {
    for (const float* r = grid_.records + std::size_t{4} * record;; r += 4, ++record) {
      test(r, record);
      if ((std::bit_cast<std::uint32_t>(r[3]) & 1U) != 0) return;
    }
  }
  void test(const float* r, std::uint32_t record) {
    const float ax = r[0] - ox_, ay = r[1] - oy_, bx = r[2] - ox_, by = r[3] - oy_;
    const float side_a = dx_ * ay - dy_ * ax, side_b = dx_ * by - dy_ * bx;
    const float lower = std::min(side_a, side_b), upper = std::max(side_a, side_b);
    if (side_ < lower || upper < -side_) return;
    const float t_a = dx_ * ax + dy_ * ay, t_b = dx_ * bx + dy_ * by;
    float low = std::min(t_a, t_b) - time_, high = std::max(t_a, t_b) + time_;
    const bool sure = lower < -side_ && side_ < upper;
    if (sure) {
      const float slope = (t_b - t_a) / (side_a - side_b), t = t_a + side_a * slope;
      const float error = time_ + side_ * std::fabs(slope);
      low = t - error;
      high = t + error;
    }
    if (high < 0 || limit_ < low) return;
    if (r[0] == left_ax_ && r[1] == left_ay_ && r[2] == left_bx_) return;
    if (sure && 0 < low && high < high_) {
      other_ = std::min(other_, low_);
      low_ = low;
      high_ = high;
      best_ = static_cast<int>(record);
    } else {
      other_ = std::min(other_, low);
    }
  }
  int verdict() const {
    if (high_ < other_) return best_;
    return other_ < kFar ? lanes::kDoubt : lanes::kNoRecord;
  }

  const lanes::Grid& grid_;
  const float side_, time_, near_, ox_, oy_, dx_, dy_, inverse_x_, inverse_y_;
  const bool left_, down_;
  const float from_x_, from_y_;
  const int quadrant_;
  float left_ax_ = NAN, left_ay_ = NAN, left_bx_ = NAN;
  float cell_ = 1, limit_ = 0, low_ = kFar, high_ = kFar, other_ = kFar;
  int best_ = lanes::kNoRecord;
};

}  // namespace

int walk_single(const lanes::Grid& grid, const lanes::Walking& ray) {
  return Walk(grid, ray).run();
}

int scan_single(const lanes::Grid& grid, const lanes::Walking& ray) {
  return Walk(grid, ray).scan();
}

}  // namespace flatray
