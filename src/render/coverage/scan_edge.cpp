#include "render/coverage/scan_edge.h"

#include <cmath>

#include "base/portable_math.h"
#include "geom/decide.h"
#include "geom/exact.h"

namespace flatray {
namespace {

// Area between a chord and its arc of the unit circle, at most half a turn: asin s - s sqrt(1 - s^2),
// s = chord / 2; where the two terms cancel, their series, which leaves out less than 2^-43 of it.
double circle_segment(double chord) {
  const double s = std::min(0.5 * chord, 1.0), z = s * s;
  if (s < 0x1p-4) {
    const double tail =
        2.0 / 3 + z * (1.0 / 5 + z * (3.0 / 28 + z * (5.0 / 72 + z * (35.0 / 704))));
    return chord * s * s * 0.5 * tail;
  }
  return portable::asin(s) - s * std::sqrt(1 - z);
}

constexpr double kNear = 0x1p16;  // beyond this many pixels an edge is anchored near the film

// From the upper to the lower end.
void direct(ScanEdge& e, const Vec2& a, const Vec2& b) {
  const bool down = a.y() < b.y() || (a.y() == b.y() && a.x() < b.x());
  const Vec2 &top = down ? a : b, &bottom = down ? b : a;
  e.x_top = e.x_ref = top.x(), e.y_top = e.y_ref = top.y();
  e.x_bottom = bottom.x(), e.y_bottom = bottom.y();
  e.direction = down ? 1 : -1;
}

// A point of a long edge near the film, rounded once from the exact one, so that errors are those of
// the film and not of the edge.
void anchor(ScanEdge& e, const Vec2& middle) {
  const Rational dx = Rational(e.x_bottom) - Rational(e.x_top);
  const Rational dy = Rational(e.y_bottom) - Rational(e.y_top);
  if (dx == 0 || dy == 0) return;
  const Rational slope = dx / dy, inverse = dy / dx;
  e.slope = slope.nearest();
  e.inverse = inverse.nearest();
  if (std::abs(e.slope) <= 1) {
    e.y_ref = clamp_to(middle.y(), e.y_top, e.y_bottom);
    e.x_ref = (Rational(e.x_top) + (Rational(e.y_ref) - Rational(e.y_top)) * slope).nearest();
  } else {
    e.x_ref = clamp_between(middle.x(), e.x_top, e.x_bottom);
    e.y_ref = (Rational(e.y_top) + (Rational(e.x_ref) - Rational(e.x_top)) * inverse).nearest();
  }
}

void straighten(ScanEdge& e, const Vec2& a, const Vec2& b, const Vec2& middle) {
  direct(e, a, b);
  const double far = std::max(std::max(std::abs(e.x_top), std::abs(e.x_bottom)),
                              std::max(std::abs(e.y_top), std::abs(e.y_bottom)));
  const double dx = e.x_bottom - e.x_top, dy = e.y_bottom - e.y_top;
  // Beside the film only that it is there counts.
  const bool beside =
      std::max(e.x_top, e.x_bottom) < 0 || std::min(e.x_top, e.x_bottom) > 2 * middle.x();
  if (far > kNear && !beside) {
    anchor(e, middle);
  } else {
    if (dy != 0) e.slope = dx / dy;
    if (dx != 0) e.inverse = dy / dx;
  }
}

// The middles of an ellipse's level chords lie on a line through its centre.
bool is_on_right_half(const Vec2& p, const Ellipse& ellipse) {
  if (ellipse.is_circle()) return p.x() >= ellipse.centre.x();
  return decide([&](const auto& number) {
           const auto u = pair_of(number, ellipse.u), v = pair_of(number, ellipse.v);
           const auto w = pair_of(number, p) - pair_of(number, ellipse.centre);
           return w.x * (u.y * u.y + v.y * v.y) - w.y * (u.x * u.y + v.x * v.y);
         }) != Sign::negative;
}

}  // namespace

// The differences do not cancel near the ends, and no square overflows.
double EdgeCurve::Branch::at(double d) const {
  const double left = inside(d);
  return shear * d + (left > 0 ? reach * std::sqrt(left) : 0);
}

EdgeCurve::EdgeCurve(const EllipseArc& arc, const MonotoneArc& part)
    : ellipse(arc.centre, arc.u, arc.v), det(cross(arc.u, arc.v)) {
  const double size = std::max(arc.u.cwiseAbs().maxCoeff(), arc.v.cwiseAbs().maxCoeff());
  const double scale = size > 0x1p500 ? 0x1p-1000 : 1;  // so that squares do not overflow
  const Vec2 u = scale * arc.u, v = scale * arc.v, step = part.b - part.a;
  const double squares_y = u.y() * u.y() + v.y() * v.y();
  const double squares_x = u.x() * u.x() + v.x() * v.x();
  const double product = u.x() * u.y() + v.x() * v.y();
  const double h = std::sqrt(squares_y), w = std::sqrt(squares_x), area = std::abs(cross(u, v));
  // Round the centre from x to y an ellipse rises on its right and runs leftward at its far y.
  const bool turns = (cross(u, v) > 0) == (arc.sweep > 0);
  side = (step.y() > 0) == turns ? 1 : -1;
  const double far = (step.x() < 0) == turns ? 1 : -1;
  const auto branch = [&](double squares, double way, double half) {
    return Branch{product / squares, way * area / half / scale, half / scale, scale / half};
  };
  rounding = 0x1p-46 * (arc.centre.cwiseAbs().maxCoeff() + 2 * size);
  x = branch(squares_y, side, h);
  y = branch(squares_x, far, w);
}

double EdgeCurve::bow(double dx, double dy) const {
  const Vec2 chord(dx, dy);
  const double a = cross(chord, ellipse.v) / det, b = cross(ellipse.u, chord) / det;
  const double area = std::abs(det) * circle_segment(std::sqrt(a * a + b * b));
  return area < kInfinity ? -side * area : 0;
}

// In film coordinates, y down, what lies left of an edge in the picture is on its positive side.
bool ScanEdge::has_on_right(double x, double y) const {
  if (curve == nullptr)
    return orientation({x_top, y_top}, {x_bottom, y_bottom}, {x, y}) != Sign::positive;
  const bool right_half = is_on_right_half({x, y}, curve->ellipse);
  const Sign outside = curve_side({x, y}, curve->ellipse);
  return curve->side > 0 ? right_half && outside != Sign::negative
                         : right_half || outside != Sign::positive;
}

// In place: a copy of what was just written waits for it.
void ScanEdges::add(const Segment& edge) {
  straighten(edges_.emplace_back(), edge.a, edge.b, middle_);
}

void ScanEdges::add(const FillRing& ring) {
  const auto circle = [&](double r, double sweep) {
    if (r > 0) add(EllipseArc{ring.centre, {r, 0}, {0, r}, 0, sweep});
  };
  circle(ring.radius, 2 * std::numbers::pi);
  circle(ring.inner_radius, -2 * std::numbers::pi);
}

void ScanEdges::add(const FillArcs& region) {
  const std::vector<EllipseArc>& arcs = region.path.arcs;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    add(arcs[i]);
    add(Segment{arcs[i].end(), arcs[(i + 1) % arcs.size()].start()});
  }
}

void ScanEdges::add(const EllipseArc& arc) {
  const std::size_t first = edges_.size();
  std::vector<EdgeCurve*> curves;
  for (const MonotoneArc& part : monotone_parts(arc)) curves.push_back(add_part(arc, part));
  // Where it turns back both parts go on alike.
  const std::size_t count = curves.size(), joints = arc.is_whole() ? count : count - 1;
  for (std::size_t i = 0; count > 0 && i < joints; ++i) {
    const std::size_t next = i + 1 == count ? 0 : i + 1;
    const int down = edges_[first + i].direction;
    if (curves[i] == nullptr || curves[next] == nullptr || down == edges_[first + next].direction)
      continue;
    for (EdgeCurve* curve : {curves[i], curves[next]})
      (down > 0 ? curve->below : curve->above) = curve->rounding;
  }
}

// Null where it is straight.
EdgeCurve* ScanEdges::add_part(const EllipseArc& arc, const MonotoneArc& part) {
  add(Segment{part.a, part.b});
  const Vec2 step = part.b - part.a;
  if (cross(arc.u, arc.v) == 0 || step.x() == 0 || step.y() == 0) return nullptr;
  ScanEdge& edge = edges_.back();
  EdgeCurve& curve = curves_.emplace_back(arc, part);
  edge.curve = &curve;
  edge.x_ref = arc.centre.x();
  edge.y_ref = arc.centre.y();
  return &curve;
}

}  // namespace flatray
