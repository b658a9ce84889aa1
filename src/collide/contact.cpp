#include "collide/contact.h"

#include <algorithm>
#include <utility>

#include "collide/minkowski.h"
#include "geom/bounds.h"
#include "geom/clip_range.h"
#include "geom/predicates.h"

namespace flatray {
namespace {

// Two polygons and the outline of their difference, with the origin moving across it.
class Pair {
 public:
  Pair(const MovingPolygon& a, const MovingPolygon& b)
      : a_(a), b_(b), difference_(minkowski_difference(a.vertices, b.vertices)) {}

  // What the whole line of motion has in common with the difference; edges are its corners.
  LineHit hit_line() const;
  // Where the origin lies in it.
  StartPlace place() const;
  ContactFeature feature(int corner) const;

 private:
  using Corner = DifferenceCorner;
  const Corner& corner(std::size_t k) const { return difference_.corners[k]; }
  std::size_t size() const { return difference_.corners.size(); }
  const Vec2& vertex_a(const Corner& c) const { return a_.vertices[c.a]; }
  const Vec2& vertex_b(const Corner& c) const { return b_.vertices[c.b]; }
  Segment edge(const Corner& c) const {
    return c.edge_of_a ? Segment{vertex_a(c), a_.vertices[c.along]}
                       : Segment{b_.vertices[c.along], vertex_b(c)};
  }
  // Side of a corner seen along the motion of B relative to A: positive to the left.
  Sign side(std::size_t k) const {
    return cross_sign(a_.velocity, b_.velocity, vertex_b(corner(k)), vertex_a(corner(k)));
  }
  HitTime time_on(const Vec2& of_a, const Vec2& of_b, const Segment& line) const {
    return HitTime::on_moving_line({of_b, b_.velocity}, of_a, line.a, line.b, a_.velocity);
  }
  HitTime time_at(int corner) const;
  LineHit hit_along() const;

  const MovingPolygon &a_, &b_;
  const Difference difference_;
};

HitTime Pair::time_at(int number) const {
  const Corner& c = corner(static_cast<std::size_t>(number));
  return time_on(vertex_a(c), vertex_b(c), edge(c));
}

// Everything lies on the line of motion.
LineHit Pair::hit_along() const {
  const int axis = a_.velocity.x() != b_.velocity.x() ? 0 : 1;
  const Segment across = {{0, 0}, axis == 0 ? Vec2(0, 1) : Vec2(1, 0)};
  const auto ends = [axis](std::span<const Vec2> ring) {
    const auto found =
        std::minmax_element(ring.begin(), ring.end(),
                            [axis](const Vec2& p, const Vec2& q) { return p[axis] < q[axis]; });
    return Segment{*found.first, *found.second};
  };
  const Segment a = ends(a_.vertices), b = ends(b_.vertices);
  HitTime low = time_on(a.a, b.b, across), high = time_on(a.b, b.a, across);
  if (b_.velocity[axis] < a_.velocity[axis]) std::swap(low, high);
  const bool point = a.a[axis] == a.b[axis] && b.a[axis] == b.b[axis];
  return {low, high, kNoEdge, kNoEdge, point ? HitClass::touch : HitClass::along};
}

// The sides of the corners tell the edges by which the origin comes in and goes out, so that no two
// times are compared (geom/sides.h).
LineHit Pair::hit_line() const {
  int down = kNoEdge, up = kNoEdge;
  bool left = false, right = false, edge_on_line = false;
  Sign from = side(0);
  const Sign first = from;
  for (std::size_t k = 0; k < size(); ++k) {
    const Sign to = k + 1 == size() ? first : side(k + 1);
    if (from > to && down == kNoEdge) down = static_cast<int>(k);
    if (from < to && up == kNoEdge) up = static_cast<int>(k);
    left |= from == Sign::positive;
    right |= from == Sign::negative;
    edge_on_line |= from == Sign::zero && to == Sign::zero;
    from = to;
  }
  if (!left && !right) return hit_along();
  if (down == kNoEdge) return {};
  const bool crosses = left && right && difference_.has_area;
  return {time_at(down), time_at(up), down, up,
          crosses        ? HitClass::through
          : edge_on_line ? HitClass::along
                         : HitClass::touch};
}

StartPlace Pair::place() const {
  if (difference_.has_area) {
    bool on_line = false;
    for (const Corner& c : difference_.corners) {
      const Segment line = edge(c);
      const Sign side = cross_sign(line.a, line.b, vertex_a(c), vertex_b(c));
      if (side == Sign::negative) return StartPlace::outside;
      on_line |= side == Sign::zero;
    }
    return on_line ? StartPlace::boundary : StartPlace::inside;
  }
  // A segment or a point: on its line, and within its box.
  const Corner& c = difference_.corners.front();
  const Segment line = edge(c);
  if (cross_sign(line.a, line.b, vertex_a(c), vertex_b(c)) != Sign::zero)
    return StartPlace::outside;
  Bounds box_a, box_b;
  for (const Vec2& p : a_.vertices) box_a.add(p);
  for (const Vec2& p : b_.vertices) box_b.add(p);
  const bool meet = (box_a.low.array() <= box_b.high.array()).all() &&
                    (box_b.low.array() <= box_a.high.array()).all();
  return meet ? StartPlace::boundary : StartPlace::outside;
}

ContactFeature Pair::feature(int number) const {
  if (number == kNoEdge) return {};
  const Corner& c = corner(static_cast<std::size_t>(number));
  return {c.edge_of_a, static_cast<int>(c.edge), static_cast<int>(c.edge_of_a ? c.b : c.a)};
}

}  // namespace

const char* contact_name(StartPlace start) {
  switch (start) {
    case StartPlace::outside:
      return "apart";
    case StartPlace::boundary:
      return "touching";
    case StartPlace::inside:
      break;
  }
  return "overlapping";
}

Contact contact(const MovingPolygon& a, const MovingPolygon& b, Range within) {
  const Pair pair(a, b);
  Contact found;
  if (a.velocity == b.velocity) {
    found.times = point_test(pair.place(), within);
    return found;
  }
  found.times = clip_to_range(pair.hit_line(), within);
  found.first = pair.feature(std::exchange(found.times.edge_enter, kNoEdge));
  found.last = pair.feature(std::exchange(found.times.edge_exit, kNoEdge));
  return found;
}

}  // namespace flatray
