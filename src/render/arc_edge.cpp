#include "render/arc_edge.h"

#include "render/circle_segment.h"

namespace flatray {
namespace {

// Written so that a NaN gives `a`.
double between(double v, double a, double b) {
  const auto [low, high] = std::minmax(a, b);
  return v > low ? (v < high ? v : high) : low;
}

double straight_at(double y, double y0, double y1, double x0, double x1) {
  if (y == y0) return x0;
  if (y == y1) return x1;
  return between(x0 + (y - y0) * ((x1 - x0) / (y1 - y0)), x0, x1);
}

}  // namespace

double ArcEdge::Branch::at(double d) const {
  const double inside = (half - d) * (half + d);  // does not cancel near the ends
  return centre + shear * d + (inside > 0 ? reach * (std::sqrt(inside) / half) : 0);
}

ArcEdge::ArcEdge(const Vec2& a, const Vec2& b) {
  const bool down = a.y() < b.y() || (a.y() == b.y() && a.x() < b.x());
  const Vec2 &top = down ? a : b, &bottom = down ? b : a;
  x_top = top.x(), y_top = top.y(), x_bottom = bottom.x(), y_bottom = bottom.y();
  direction = down ? 1 : -1;
}

ArcEdge::ArcEdge(const EllipseArc& arc, const MonotoneArc& part) : ArcEdge(part.a, part.b) {
  det_ = cross(arc.u, arc.v);
  const Vec2 step = part.b - part.a;
  straight_ = det_ == 0 || step.x() == 0 || step.y() == 0;
  if (straight_) return;
  centre_ = arc.centre, u_ = arc.u, v_ = arc.v;
  const double squares_y = u_.y() * u_.y() + v_.y() * v_.y();
  const double squares_x = u_.x() * u_.x() + v_.x() * v_.x();
  const double product = u_.x() * u_.y() + v_.x() * v_.y();
  const double h = std::sqrt(squares_y), w = std::sqrt(squares_x);
  // Round the centre from x to y an ellipse rises on its right and runs leftward at its far y.
  const bool turns = (det_ > 0) == (arc.sweep > 0);
  side_ = (step.y() > 0) == turns ? 1 : -1;
  const double far = (step.x() < 0) == turns ? 1 : -1;
  x_ = {centre_.x(), product / squares_y, side_ * std::abs(det_) / h, h};
  y_ = {centre_.y(), product / squares_x, far * std::abs(det_) / w, w};
}

double ArcEdge::x_at(double y) const {
  if (straight_) return straight_at(y, y_top, y_bottom, x_top, x_bottom);
  if (y == y_top) return x_top;
  return between(x_.at(y - centre_.y()), x_top, x_bottom);
}

double ArcEdge::y_at(double x) const {
  if (straight_) return straight_at(x, x_top, x_bottom, y_top, y_bottom);
  if (x == x_top) return y_top;
  return between(y_.at(x - centre_.x()), y_top, y_bottom);
}

double ArcEdge::bow(const Vec2& chord) const {
  if (straight_) return 0;
  const double a = cross(chord, v_) / det_, b = cross(u_, chord) / det_;
  const double area = std::abs(det_) * circle_segment(1, std::sqrt(a * a + b * b));
  return area < kInfinity ? -side_ * area : 0;
}

}  // namespace flatray
