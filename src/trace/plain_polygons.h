#pragma once
#include <limits>
#include <span>

#include "geom/predicates.h"
#include "trace/plain.h"
#include "trace/tracer.h"

// The paper's own method in plain arithmetic, without bounds: for the tracers that are not exact.
namespace flatray::plain {

/// An edge from P with the outward normal n = (e_y, -e_x) of a convex polygon.
template <class Number>
struct Edge {
  Number px, py, nx, ny;
  std::uint32_t surface = kNoSurface;
};

/// The part of a ray inside a convex polygon, empty where t_enter > t_exit, and the surfaces it enters
/// and leaves by.
template <class Number>
struct Interval {
  Number t_enter = -std::numeric_limits<Number>::infinity();
  Number t_exit = std::numeric_limits<Number>::infinity();
  std::uint32_t entered = kNoSurface, left = kNoSurface;
};

/// Cyrus-Beck, edge by edge: numer = n.(P - A), denom = n.c for a ray from A along c, t = numer / denom.
///
/// Source  the paper's table 1 and eq. 3, as corrected in docs/DEVIATIONS.md.
template <class Number>
Interval<Number> clip(const Start<Number>& ray, std::span<const Edge<Number>> edges) {
  Interval<Number> inside;
  for (const Edge<Number>& edge : edges) {
    const Number numer = edge.nx * (edge.px - ray.x) + edge.ny * (edge.py - ray.y);
    const Number denom = edge.nx * ray.dx + edge.ny * ray.dy;
    if (denom == 0) {
      if (numer < 0) inside.t_exit = -std::numeric_limits<Number>::infinity();
      continue;
    }
    const Number t = numer / denom;
    if (denom < 0 && t > inside.t_enter) inside.t_enter = t, inside.entered = edge.surface;
    if (denom > 0 && t < inside.t_exit) inside.t_exit = t, inside.left = edge.surface;
  }
  return inside;
}

/// Every convex polygon against every ray; what is none, segment by segment, each as the polygon
/// without area between its ends.
template <class Number>
class Polygons : public Accelerator {
 public:
  explicit Polygons(const Surfaces& walls) : Accelerator(walls) {
    for (std::size_t i = 0; i < walls.segments.size();) {
      const std::size_t count = convex_ring(i);
      if (count == 0)
        add_segment(i++);
      else
        add_ring(i, count), i += count;
    }
  }

  NearestHit nearest_of_one(const Ray& ray, const DepartedSurface& departed, bool) const override {
    const auto start = start_of<Number>(ray);
    NearestHit best;
    for (std::size_t i = 0; i + 1 < begin_.size(); ++i) {
      const Interval<Number> inside =
          clip<Number>(start, std::span(edges_).subspan(begin_[i], begin_[i + 1] - begin_[i]));
      if (!(inside.t_enter <= inside.t_exit)) continue;
      const bool enters = inside.t_enter >= 0 && inside.entered != departed.surface;
      const Number t = enters ? inside.t_enter : inside.t_exit;
      const std::uint32_t surface = enters ? inside.entered : inside.left;
      if (surface == departed.surface || !(t >= 0 && static_cast<double>(t) < best.t)) continue;
      best = {surface, HitClass::touch, Root::none, false, static_cast<double>(t)};
    }
    offer_curves<Number>(walls_, ray, departed, best);
    return best;
  }
  std::size_t bytes() const override {
    return edges_.size() * sizeof(Edge<Number>) + begin_.size() * sizeof(std::size_t);
  }

 private:
  // How many segments from the i-th on are the outline of a convex polygon with area, each from the
  // end of the one before; 0: it begins none.
  std::size_t convex_ring(std::size_t first) const {
    const std::vector<Segment>& all = walls_.segments;
    std::size_t count = 1;
    while (first + count < all.size() && all[first + count].a == all[first + count - 1].b &&
           all[first + count - 1].b != all[first].a)
      ++count;
    if (count < 3 || all[first + count - 1].b != all[first].a) return 0;
    const Sign turn = orientation(all[first].a, all[first].b, all[first + 1].b);
    int rises = 0;  // that follow falls: one, where it winds once
    for (std::size_t i = 0; i < count; ++i) {
      const Segment &one = all[first + i], &next = all[first + (i + 1) % count];
      if (turn == Sign::zero || orientation(one.a, one.b, next.b) != turn) return 0;
      const auto rise = [](const Segment& s) {
        return s.b.y() > s.a.y() || (s.b.y() == s.a.y() && s.b.x() > s.a.x());
      };
      rises += !rise(one) && rise(next) ? 1 : 0;
    }
    return rises == 1 ? count : 0;
  }

  void add_ring(std::size_t first, std::size_t count) {
    const Segment* const ring = &walls_.segments[first];
    const bool counter_clockwise = orientation(ring[0].a, ring[0].b, ring[1].b) == Sign::positive;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec2 edge =
          counter_clockwise ? Vec2(ring[i].b - ring[i].a) : Vec2(ring[i].a - ring[i].b);
      add(ring[i].a, {edge.y(), -edge.x()}, first + i);
    }
    begin_.push_back(edges_.size());
  }
  void add_segment(std::size_t i) {
    const Segment& wall = walls_.segments[i];
    const Vec2 edge = wall.b - wall.a, normal(edge.y(), -edge.x());
    add(wall.a, normal, i), add(wall.a, -normal, i), add(wall.a, -edge, i), add(wall.b, edge, i);
    begin_.push_back(edges_.size());
  }
  void add(const Vec2& point, const Vec2& normal, std::size_t segment) {
    const auto number = [](double x) { return static_cast<Number>(x); };
    edges_.push_back({number(point.x()), number(point.y()), number(normal.x()), number(normal.y()),
                      walls_.segment_numbers[segment]});
  }

  std::vector<Edge<Number>> edges_;
  std::vector<std::size_t> begin_{0};  // of each polygon, and the end
};

}  // namespace flatray::plain
