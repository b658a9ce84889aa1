#include "geom/convex_polygon.h"

#include "geom/polygon_edges.h"
#include "geom/sides.h"

namespace flatray {
namespace {

// Up to this many edges looking at each is as fast (benchmarks/convex_clip).
constexpr std::size_t kFewEdges = 63;

// First k in [begin, end) for which `holds`, which stays true from there on; end for none.
template <class Holds>
std::size_t first_where(std::size_t begin, std::size_t end, const Holds& holds) {
  while (begin < end) {
    const std::size_t middle = begin + (end - begin) / 2;
    if (holds(middle))
      end = middle;
    else
      begin = middle + 1;
  }
  return begin;
}

// The vertices from one extreme to the other, along which sides change one way only.
class Chain {
 public:
  Chain(const Ray& ray, std::span<const Vec2> vertices, std::size_t from, std::size_t to)
      : ray_(ray), vertices_(vertices), from_(from) {
    steps_ = (to + vertices.size() - from) % vertices.size();
  }

  std::size_t vertex(std::size_t step) const { return (from_ + step) % vertices_.size(); }
  Sign side(std::size_t step) const { return side_of_ray(ray_, vertices_[vertex(step)]); }
  // First step whose side is another than the first one's; one more than there are for none.
  std::size_t first_change(Sign from) const {
    return first_where(1, steps_ + 1, [&](std::size_t step) { return side(step) != from; });
  }
  // The lowest edge along which the side changes; kNoEdge for none.
  int lowest_change() const {
    const Sign from = side(0), to = side(steps_);
    if (from == to) return kNoEdge;
    const std::size_t leaves = first_change(from);
    const std::size_t arrives =
        first_where(leaves, steps_ + 1, [&](std::size_t step) { return side(step) == to; });
    return static_cast<int>(std::min(vertex(leaves - 1), vertex(arrives - 1)));
  }
  std::size_t steps() const { return steps_; }

 private:
  const Ray& ray_;
  std::span<const Vec2> vertices_;
  std::size_t from_, steps_ = 0;
};

}  // namespace

ConvexPolygon::ConvexPolygon(std::span<const Vec2> vertices) : vertices_(vertices) {
  if (vertices.size() <= kFewEdges) return;
  for (const std::size_t edge : proper_edges(vertices))
    edges_.push_back(static_cast<std::uint32_t>(edge));
  Sign sense = Sign::zero;
  for (std::size_t k = 1; k < edges_.size() && turned_ == 0; ++k) {
    const Vec2 &a = vertices[edges_[0]], &b = edge_end(vertices, edges_[0]);
    const Vec2 &c = vertices[edges_[k]], &d = edge_end(vertices, edges_[k]);
    const Sign turn = cross_sign(a, b, c, d);
    if (sense == Sign::zero) sense = turn;
    // A direction across d - c has the sign of the dot product as its cross product.
    const bool back = cross_sign(a, b, {-c.y(), c.x()}, {-d.y(), d.x()}) == Sign::negative;
    if (turn == -sense && (turn != Sign::zero || back)) turned_ = k;
    if (turn == Sign::zero && back) turned_ = k;
  }
  if (sense == Sign::zero || turned_ == 0) edges_.clear();
}

// Whether an edge leads to the left of the direction (positive) or to its right.
Sign ConvexPolygon::way(const Vec2& direction, std::size_t edge) const {
  const std::size_t i = edges_[edge];
  return -turn_from_edge(vertices_[i], edge_end(vertices_, i), direction);
}

// Edges of half a turn lead first one way, then perhaps along the direction, then the other.
void ConvexPolygon::add_changes(const Vec2& direction, std::size_t begin, std::size_t end,
                                std::vector<std::size_t>& changes) const {
  while (begin < end) {
    changes.push_back(begin);
    const Sign first = way(direction, begin);
    begin = first_where(begin + 1, end,
                        [&](std::size_t edge) { return way(direction, edge) != first; });
  }
}

ConvexPolygon::Extremes ConvexPolygon::extremes(const Vec2& direction) const {
  std::vector<std::size_t> changes;
  add_changes(direction, 0, turned_, changes);
  add_changes(direction, turned_, edges_.size(), changes);
  Extremes found;
  for (const std::size_t edge : changes) {
    const Sign before = way(direction, (edge == 0 ? edges_.size() : edge) - 1);
    const Sign here = way(direction, edge);
    if (here == Sign::negative && before != here) found.left = edges_[edge];
    if (here == Sign::positive && before != here) found.right = edges_[edge];
  }
  return found;
}

HitInterval ConvexPolygon::clip(const Ray& ray, Range within) const {
  if (edges_.empty() || is_zero(ray.direction)) return clip_convex(ray, vertices_, within);
  const auto [left, right] = extremes(ray.direction);
  const Chain down(ray, vertices_, left, right), up(ray, vertices_, right, left);
  const Sign farthest_left = down.side(0), farthest_right = up.side(0);
  Sides sides{down.lowest_change(), up.lowest_change(), farthest_left == Sign::positive,
              farthest_right == Sign::negative, false};
  // Where the line touches, the vertices on it are those about one extreme.
  if (farthest_left == Sign::zero || farthest_right == Sign::zero) {
    const bool at_left = farthest_left == Sign::zero;
    const Chain& leaving = at_left ? down : up;
    const Chain& coming = at_left ? up : down;
    const std::size_t last = leaving.vertex(leaving.first_change(Sign::zero) - 1);
    const std::size_t first = coming.vertex(coming.first_change(coming.side(0)));
    sides.edge_on_line = vertices_[first] != vertices_[last];
  }
  return clip_to_range(hit_line(ray, vertices_, sides), within);
}

}  // namespace flatray
