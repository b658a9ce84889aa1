#include "render/coverage_edges.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "geom/exact.h"

namespace flatray {
namespace {

constexpr double kUnit = 0x1p-53;  // u: half an ulp of 1
constexpr double kNear = 0x1p16;   // beyond this many pixels an edge is anchored near the box
constexpr double kGrid =
    0x1p8;  // ends on multiples of 1 / kGrid and slopes of a small power of two
constexpr double kSteepest = 0x1p4;  // give exact cuts: multiples of 2^-12, areas of 2^-29

// Needs |v| <= kNear.
bool on_grid(double v) {
  return v * kGrid == static_cast<double>(static_cast<std::int64_t>(v * kGrid));
}

// dx / dy is +-2^k with |k| small, or the edge lies along an axis.
bool exact_slope(double dx, double dy, double slope) {
  if (dx == 0 || dy == 0) return true;
  constexpr std::uint64_t kFraction = (std::uint64_t{1} << 52) - 1;
  const double steep = std::abs(slope);
  return (std::bit_cast<std::uint64_t>(slope) & kFraction) == 0 && slope * dy == dx &&
         steep <= kSteepest && steep >= 1 / kSteepest;
}

// x_at: the difference, the slope (of two rounded differences and a quotient) and the product make
// a relative error below 5.1 u of a term not larger than |dx|; the sum adds u |x|. y_at likewise.
void bound_near(ScanEdge& e, double dx, double dy) {
  const double x = std::max(std::abs(e.x_top), std::abs(e.x_bottom));
  const double y = std::max(std::abs(e.y_top), std::abs(e.y_bottom));
  const bool along_axis =
      dx == 0 || dy == 0;  // the one coordinate is copied, the other one is a border
  e.error_x = along_axis ? 0 : kUnit * (6 * std::abs(dx) + x);
  e.error = along_axis ? 0 : std::max(e.error_x, kUnit * (6 * std::abs(dy) + y));
}

// A long edge: a point of it near the box, rounded once from the exact one, so that errors are
// those of the box and not of the edge. `error` is measured along the axis the edge is steep
// against.
void anchor(ScanEdge& e, const PixelBox& box) {
  const Rational dx = Rational(e.x_bottom) - Rational(e.x_top);
  const Rational dy = Rational(e.y_bottom) - Rational(e.y_top);
  if (dx == 0 || dy == 0) return;
  const Rational slope = dx / dy, inverse = dy / dx;
  e.slope = slope.nearest();
  e.inverse = inverse.nearest();
  const double middle_x = box.x + 0.5 * box.width, middle_y = box.y + 0.5 * box.height;
  const double reach = std::abs(box.x) + std::abs(box.y) + box.width + box.height + 2.0;
  if (std::abs(e.slope) <= 1) {
    e.y_ref = std::clamp(middle_y, e.y_top, e.y_bottom);
    e.x_ref = (Rational(e.x_top) + (Rational(e.y_ref) - Rational(e.y_top)) * slope).nearest();
    e.error = e.error_x = kUnit * (3 * std::abs(e.x_ref) + 6 * reach);
  } else {
    e.x_ref = std::clamp(middle_x, std::min(e.x_top, e.x_bottom), std::max(e.x_top, e.x_bottom));
    e.y_ref = (Rational(e.y_top) + (Rational(e.x_ref) - Rational(e.x_top)) * inverse).nearest();
    e.error = kUnit * (3 * std::abs(e.y_ref) + 6 * reach);
    e.error_x = 2 * kUnit * std::abs(e.y_ref) * std::abs(e.slope) +
                kUnit * (6 * reach + 3 * std::abs(e.x_ref));
    if (!std::isfinite(e.error_x)) e.error_x = kInfinity;
  }
}

}  // namespace

ScanEdge scan_edge(const Segment& edge, const PixelBox& box) {
  const bool down =
      edge.a.y() < edge.b.y() || (edge.a.y() == edge.b.y() && edge.a.x() < edge.b.x());
  const Vec2& top = down ? edge.a : edge.b;
  const Vec2& bottom = down ? edge.b : edge.a;
  ScanEdge e{top.x(), top.y(), bottom.x(), bottom.y(), top.x(),       top.y(),
             0,       0,       0,          0,          down ? 1 : -1, false};
  const double far = std::max(std::max(std::abs(e.x_top), std::abs(e.x_bottom)),
                              std::max(std::abs(e.y_top), std::abs(e.y_bottom)));
  if (far > kNear) {
    const bool beside =
        std::max(e.x_top, e.x_bottom) < box.x || std::min(e.x_top, e.x_bottom) > box.x + box.width;
    if (!beside) anchor(e, box);  // beside the box only its winding counts
    return e;
  }
  const double dx = e.x_bottom - e.x_top, dy = e.y_bottom - e.y_top;
  if (dy != 0) e.slope = dx / dy;
  if (dx != 0) e.inverse = dy / dx;
  e.exact = exact_slope(dx, dy, e.slope) && on_grid(e.x_top) && on_grid(e.y_top) &&
            on_grid(e.x_bottom) && on_grid(e.y_bottom);
  if (!e.exact) bound_near(e, dx, dy);
  return e;
}

}  // namespace flatray
