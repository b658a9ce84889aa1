// Certifies edges of Minkowski differences. Lanes are edges. It works in doubles, and says so where those
// leave a doubt.

struct Point {
  Real x, y;
};

// After what it is made of.
#include "trace/kernels/quotient_body.h"

struct WidePoint {
  Pair x, y;
  Point high() const { return {x.high, y.high}; }
};

inline WidePoint step(const Point& from, const Point& to) {
  return {difference(to.x, from.x), difference(to.y, from.y)};
}
inline Known cross(const WidePoint& a, const WidePoint& b) { return cross(a.x, a.y, b.x, b.y); }

// Of a x b in plain doubles (geom/error_bounds.h): whether it is positive, and whether that and
// its being negative is certain.
struct Side {
  Mask is_positive, is_certain;
};
inline Side side(const Point& a, const Point& b) {
  const Real left = a.x * b.y, right = a.y * b.x;
  const Real terms = size(left) + size(right);
  return {less(right, left), both(less(all(kDetFilterLeast), terms),
                                  less(all(kDetFilter) * terms, size(left - right)))};
}

inline Mask is_zero(Real a) { return equal(a, all(0)); }

// Where a x b is 0, if all that it is made of is exact.
inline Mask are_parallel(const WidePoint& a, const WidePoint& b) {
  const Mask exact =
      both(both(is_zero(a.x.low), is_zero(a.y.low)), both(is_zero(b.x.low), is_zero(b.y.low)));
  const Mask nothing = both(either(is_zero(a.x.high), is_zero(b.y.high)),
                            either(is_zero(a.y.high), is_zero(b.x.high)));
  const Pair left = product(a.x.high, b.y.high), right = product(a.y.high, b.x.high);
  const Mask same = both(equal(left.high, right.high), equal(left.low, right.low));
  const Mask usual =
      both(less(all(kExactProductLeast), size(left.high)), less(size(left.high), all(0x1p900)));
  return both(exact, either(nothing, both(same, usual)));
}

inline Mask is_certain(const Known& a) {
  return both(less(all(0x1p-800), a.terms), less(all(0x1p-99) * a.terms, size(a.rounded())));
}

// Whether a neighbour of the vertex surely lies beyond it, or is on the line of the edge.
struct Beyond {
  Mask is_nearer, is_level, is_certain;
};
inline Beyond beyond(const WidePoint& edge, const WidePoint& neighbour) {
  const Side turn = side(edge.high(), neighbour.high());
  if (full(turn.is_certain)) return {turn.is_positive, is_zero(all(1)), turn.is_certain};
  const Mask level = are_parallel(edge, neighbour);
  return {but_not(turn.is_positive, level), level, either(turn.is_certain, level)};
}

inline void certify_at(Edges& edges, int i) {
  const Ends ends = fetch_ends(edges.edge + i, 0), two = fetch_ends(edges.vertex + i, 0);
  const Ends next = fetch_ends(edges.vertex + i, 2), moves = fetch_ends(edges.moves + i, 0);
  const Real turned = load(edges.of_first + i);
  const Mask of_first = less(all(0), turned);
  const Point from = {ends.ax, ends.ay}, to = {ends.bx, ends.by}, vertex = {two.bx, two.by};
  const WidePoint edge = step(from, to), gap = step(vertex, from);
  // Of the vertex past the edge.
  const Pair way_x = difference(turned * moves.bx, turned * moves.ax);
  const Pair way_y = difference(turned * moves.by, turned * moves.ay);
  const WidePoint way = {way_x, way_y};
  const Side start = side(way.high(), gap.high());
  const Side end = side(way.high(), {to.x - vertex.x, to.y - vertex.y});
  const Beyond before = beyond(edge, step(vertex, {two.ax, two.ay}));
  const Beyond after = beyond(edge, step(vertex, {next.bx, next.by}));
  const Known numer = cross(gap, edge), denom = cross(way, edge);
  const Real time = quotient(numer, denom);
  const Mask down = less(numer.rounded(), all(0)), back = less(denom.rounded(), all(0));
  const Mask past = both(either(but_not(down, back), but_not(back, down)),
                         both(is_certain(numer), is_certain(denom)));
  const auto told = [](Mask holds, int what) { return choose(holds, all(what), all(0)); };
  const Mask certain =
      both(both(start.is_certain, end.is_certain), both(before.is_certain, after.is_certain));
  const Real found =
      choose(certain, all(0), all(kUnsure)) + told(past, kPast) +
      told(start.is_positive, kFromLeft) + told(end.is_positive, kToLeft) +
      told(either(before.is_nearer, both(before.is_level, of_first)), kRatherBefore) +
      told(either(after.is_nearer, but_not(after.is_level, of_first)), kRatherAfter);
  store(edges.time + i, time);
  store(edges.found + i, found);
}

void certify(Edges& edges, int count) {
  for (int i = 0; i < count; i += FLATRAY_LANES) certify_at(edges, i);
}
