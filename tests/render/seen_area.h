#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "geom/vec.h"

namespace flatray::coverage_check {

/// What a pixel shows of opaque convex polygons and discs, by integrals in closed form: between the
/// heights at which sides of shapes begin, end or cross, the same shapes are seen from left to right,
/// each between two sides of which lines and arcs have known integrals. Shares nothing with the
/// engine: no windings, no pieces, no sums of edges.
///
/// Error   of an area some 1e-17 for coordinates of pixels near the origin, in long double: a height
///         of a crossing is off by 1e-18, or by its root where sides touch, and what that changes is
///         of its square.
class SeenArea {
 public:
  using Number = long double;

  /// From the lowest up; a polygon with corners in either order.
  void add_polygon(const std::vector<Vec2>& corners, std::size_t item) {
    Shape shape{item, 0, 0, 0, {}};
    for (std::size_t i = 0; i < corners.size(); ++i)
      shape.lines.push_back({corners[i], corners[(i + 1) % corners.size()]});
    shapes_.push_back(shape);
  }
  void add_disc(const Vec2& centre, double radius, std::size_t item) {
    const Point at(centre);
    shapes_.push_back({item, at.x(), at.y(), static_cast<Number>(radius), {}});
  }

  /// The area seen of each of `items` items in the pixel.
  std::vector<Number> in_pixel(int x, int y, std::size_t items) const {
    const Number left = x, right = x + 1, top = y, bottom = y + 1;
    std::vector<Number> heights{top, bottom}, seen(items);
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      add_ends(shapes_[i], heights);
      for (const Number border : {left, right}) add_crossings(shapes_[i], border, heights);
      for (std::size_t k = 0; k <= i; ++k) add_crossings(shapes_[i], shapes_[k], heights);
    }
    std::erase_if(heights, [&](Number h) { return !(h >= top && h <= bottom); });
    std::sort(heights.begin(), heights.end());
    for (std::size_t i = 1; i < heights.size(); ++i)
      if (heights[i - 1] < heights[i]) add_slab(heights[i - 1], heights[i], left, right, seen);
    return seen;
  }

 private:
  class Point {
   public:
    Point(const Vec2& v) : x_(static_cast<Number>(v.x())), y_(static_cast<Number>(v.y())) {}
    Number x() const { return x_; }
    Number y() const { return y_; }

   private:
    Number x_, y_;
  };
  struct Line {
    Point a, b;
    Number x_at(Number y) const {
      return a.x() + (y - a.y()) * ((b.x() - a.x()) / (b.y() - a.y()));
    }
  };
  struct Shape {
    std::size_t item;
    Number x, y, radius;
    std::vector<Line> lines;  ///< none: a disc
  };
  /// x by y: of a line, an arc (way +-1) or a border (neither).
  struct Side {
    const Line* line = nullptr;
    const Shape* disc = nullptr;
    Number way = 0, border = 0;

    Number at(Number y) const {
      if (line != nullptr) return line->x_at(y);
      return disc == nullptr ? border : disc->x + way * half_chord(y - disc->y);
    }
    Number half_chord(Number d) const {
      const Number square = (disc->radius - d) * (disc->radius + d);
      return square > 0 ? std::sqrt(square) : 0;
    }
    Number area_to(Number d) const {  // from the middle, between the axis and the arc
      const Number r = disc->radius, share = std::clamp<Number>(d / r, -1, 1);
      return (d * half_chord(d) + r * r * std::asin(share)) / 2;
    }
    Number integral(Number from, Number to) const {
      if (disc == nullptr) return (to - from) * at((from + to) / 2);
      return (to - from) * disc->x + way * (area_to(to - disc->y) - area_to(from - disc->y));
    }
  };
  struct Stretch {
    Side low, high;
    std::size_t item;
  };

  static void add_ends(const Shape& shape, std::vector<Number>& heights) {
    for (const Line& line : shape.lines) heights.push_back(line.a.y());
    if (shape.lines.empty())
      heights.insert(heights.end(), {shape.y - shape.radius, shape.y + shape.radius});
  }
  static void add_crossings(const Shape& shape, Number border, std::vector<Number>& heights) {
    for (const Line& l : shape.lines) {
      const Number dx = l.b.x() - l.a.x(), dy = l.b.y() - l.a.y();
      if (dx != 0) heights.push_back(l.a.y() + (border - l.a.x()) * (dy / dx));
    }
    const Number d = border - shape.x, square = (shape.radius - d) * (shape.radius + d);
    if (!shape.lines.empty() || square < 0) return;
    heights.insert(heights.end(), {shape.y - std::sqrt(square), shape.y + std::sqrt(square)});
  }
  // Of whole lines: heights at which nothing crosses do no harm.
  static void add_crossings(const Shape& a, const Shape& b, std::vector<Number>& heights) {
    for (const Line& one : a.lines)
      for (const Line& other : b.lines) add_crossing(one, other, heights);
    if (a.lines.empty() && b.lines.empty()) add_circles(a, b, heights);
    if (a.lines.empty() == b.lines.empty()) return;
    const Shape &disc = a.lines.empty() ? a : b, &polygon = a.lines.empty() ? b : a;
    for (const Line& line : polygon.lines) add_crossing(line, disc, heights);
  }
  static void add_crossing(const Line& l, const Line& m, std::vector<Number>& heights) {
    const Number lx = l.b.x() - l.a.x(), ly = l.b.y() - l.a.y();
    const Number mx = m.b.x() - m.a.x(), my = m.b.y() - m.a.y();
    const Number turn = lx * my - ly * mx;
    if (turn == 0) return;
    const Number t = ((m.a.x() - l.a.x()) * my - (m.a.y() - l.a.y()) * mx) / turn;
    heights.push_back(l.a.y() + t * ly);
  }
  static void add_crossing(const Line& l, const Shape& disc, std::vector<Number>& heights) {
    const Number dx = l.b.x() - l.a.x(), dy = l.b.y() - l.a.y();
    const Number length = std::sqrt(dx * dx + dy * dy), ux = dx / length, uy = dy / length;
    const Number px = disc.x - l.a.x(), py = disc.y - l.a.y();
    const Number beside = ux * py - uy * px, along = ux * px + uy * py;
    const Number square = (disc.radius - beside) * (disc.radius + beside);
    if (square < 0) return;
    for (const Number way : {-1, 1})
      heights.push_back(l.a.y() + (along + way * std::sqrt(square)) * uy);
  }
  static void add_circles(const Shape& a, const Shape& b, std::vector<Number>& heights) {
    const Number dx = b.x - a.x, dy = b.y - a.y, d = std::sqrt(dx * dx + dy * dy);
    if (d == 0) return;
    const Number along = (d + (a.radius - b.radius) * ((a.radius + b.radius) / d)) / 2;
    const Number square = (a.radius - along) * (a.radius + along);
    if (square < 0) return;
    for (const Number way : {-1, 1})
      heights.push_back(a.y + (along * dy + way * std::sqrt(square) * dx) / d);
  }

  // Where the shape is at a height, if it is there.
  static bool add_stretch(const Shape& shape, Number y, std::vector<Stretch>& out) {
    Side low, high;
    if (shape.lines.empty()) {
      if (std::abs(y - shape.y) >= shape.radius) return false;
      low.disc = high.disc = &shape;
      low.way = -1, high.way = 1;
    } else {
      for (const Line& line : shape.lines) {
        if ((line.a.y() <= y) == (line.b.y() <= y)) continue;
        (low.line == nullptr ? low : high).line = &line;
      }
      if (high.line == nullptr) return false;
      if (low.at(y) > high.at(y)) std::swap(low, high);
    }
    out.push_back({low, high, shape.item});
    return true;
  }

  void add_slab(Number from, Number to, Number left, Number right,
                std::vector<Number>& seen) const {
    const Number y = (from + to) / 2;
    std::vector<Stretch> stretches;
    for (const Shape& shape : shapes_) add_stretch(shape, y, stretches);
    std::vector<Side> sides(2);
    sides[0].border = left, sides[1].border = right;
    for (const Stretch& stretch : stretches)
      for (const Side& side : {stretch.low, stretch.high})
        if (side.at(y) > left && side.at(y) < right) sides.push_back(side);
    std::sort(sides.begin(), sides.end(),
              [y](const Side& a, const Side& b) { return a.at(y) < b.at(y); });
    for (std::size_t i = 1; i < sides.size(); ++i) {
      const Number x = (sides[i - 1].at(y) + sides[i].at(y)) / 2;
      const auto holds = [&](const Stretch& s) { return s.low.at(y) <= x && x <= s.high.at(y); };
      const auto top = std::find_if(stretches.rbegin(), stretches.rend(), holds);
      if (top != stretches.rend())
        seen[top->item] += sides[i].integral(from, to) - sides[i - 1].integral(from, to);
    }
  }

  std::vector<Shape> shapes_;
};

}  // namespace flatray::coverage_check
