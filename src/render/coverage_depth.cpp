#include <algorithm>
#include <array>
#include <cmath>

#include "render/coverage_cell.h"

namespace flatray {
namespace {

constexpr int kParts = 16;  // of a pixel each way
constexpr double kUlp = 0x1p-52;

int part(double v) {
  return static_cast<int>(std::clamp(std::floor(v * kParts), -1.0, static_cast<double>(kParts)));
}

// Lower bounds of sign * winding in the blocks of a pixel. An edge that raises it counts from the
// first block it is certainly left of, one that lowers it from the first it may touch, and an edge
// that ends inside a strip of blocks raises nothing there.
class Depth {
 public:
  Depth(std::span<const Piece> pieces, int winding, int sign) : sign_(sign) {
    for (auto& strip : strips_) strip.fill(0);
    for (auto& left : left_) left = sign * winding;
    for (const Piece& p : pieces) error_ = std::max(error_, p.error);
    error_ = 8 * error_ + 16 * kUlp;
    for (const Piece& p : pieces) add(p);
  }

  bool positive() const {
    for (int y = 0; y < kParts; ++y) {
      int depth = left_[index(y)];
      for (int x = 0; x < kParts; ++x) {
        depth += strips_[index(y)][index(x)];
        if (depth <= 0) return false;
      }
    }
    return true;
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  void add(const Piece& p) {
    const int change = sign_ * p.direction;
    if (p.ghost) {
      for (int& left : left_) --left;
      return;
    }
    if (p.left_top) jump(p.y_top, -change);
    if (p.left_bottom) jump(p.y_bottom, change);
    const int first = std::max(part(p.y_top - error_), 0);
    const int last = std::min(part(p.y_bottom + error_), kParts - 1);
    const double slope = p.y_bottom > p.y_top ? (p.x_bottom - p.x_top) / (p.y_bottom - p.y_top) : 0;
    for (int y = first; y <= last; ++y) {
      const double top = static_cast<double>(y) / kParts, bottom = top + 1.0 / kParts;
      const double a = x_at(p, slope, top), b = x_at(p, slope, bottom);
      if (change < 0) {
        count(y, std::max(part(std::min(a, b) - error_), 0), change);
      } else if (whole(p, top, bottom)) {
        count(y, part(std::max(a, b) + error_) + 1, change);
      }
    }
  }

  // Ends on the borders of the row are exact.
  bool whole(const Piece& p, double top, double bottom) const {
    const bool above = p.y_top == 0 || p.y_top + error_ < top;
    const bool below = p.y_bottom == 1 || p.y_bottom - error_ > bottom;
    return above && below;
  }

  static double x_at(const Piece& p, double slope, double y) {
    const auto [low, high] = std::minmax(p.x_top, p.x_bottom);
    return std::clamp(p.x_top + (y - p.y_top) * slope, low, high);
  }

  void count(int y, int from, int change) {
    if (from < kParts) strips_[index(y)][index(from)] += change;
  }

  // The winding along the left border changes at y: a rise counts below the strip, a fall from it.
  void jump(double y, int change) {
    const int from = change < 0 ? std::max(part(y - error_), 0) : part(y + error_) + 1;
    for (int i = std::max(from, 0); i < kParts; ++i) left_[index(i)] += change;
  }

  const int sign_;
  double error_ = 0;
  std::array<std::array<int, kParts>, kParts> strips_;
  std::array<int, kParts> left_;
};

}  // namespace

bool certainly_full(std::span<const Piece> pieces, int winding) {
  return winding != 0 && Depth(pieces, winding, winding > 0 ? 1 : -1).positive();
}

}  // namespace flatray
