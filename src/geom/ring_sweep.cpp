#include "geom/ring_sweep.h"

#include <algorithm>
#include <numeric>

namespace flatray {

const Vec2& RingSweep::FromBelow::left(Index edge) const {
  const Vec2 &a = points[edge], &b = points[after(edge)];
  return is_before(a, b) ? a : b;
}
const Vec2& RingSweep::FromBelow::right(Index edge) const {
  const Vec2 &a = points[edge], &b = points[after(edge)];
  return is_before(a, b) ? b : a;
}
Sign RingSweep::FromBelow::side(Index edge, const Vec2& point) const {
  return orientation(left(edge), right(edge), point);
}
bool RingSweep::FromBelow::operator()(const Met& a, const Vec2& point) const {
  return side(a.edge, point) == Sign::positive;
}
bool RingSweep::FromBelow::operator()(const Met& a, const Met& b) const {
  const Vec2 &from_a = left(a.edge), &from_b = left(b.edge);
  if (from_a == from_b) return side(a.edge, right(b.edge)) == Sign::positive;
  return is_before(from_a, from_b) ? side(a.edge, from_b) == Sign::positive
                                   : side(b.edge, from_a) == Sign::negative;
}

RingSweep::RingSweep(std::span<const Vec2> points)
    : ring_{points}, vertices_(points.size()), order_(ring_), places_(points.size()) {
  std::iota(vertices_.begin(), vertices_.end(), Index{0});
  std::sort(vertices_.begin(), vertices_.end(), [&](Index a, Index b) {
    return is_before(points[a], points[b]) || (points[a] == points[b] && a < b);
  });
  for (std::size_t i = 1; i < vertices_.size(); ++i)
    if (points[vertices_[i - 1]] == points[vertices_[i]]) meet(vertices_[i - 1], vertices_[i]);
}

std::optional<RingSweep::Event> RingSweep::next() {
  if (crossing_ || at_ == vertices_.size()) return std::nullopt;
  const Index out = vertices_[at_++];
  const Index in = out == 0 ? static_cast<Index>(vertices_.size()) - 1 : out - 1;
  const Vec2& vertex = ring_.points[out];
  const bool in_ends = is_before(ring_.points[in], vertex);
  const bool out_ends = is_before(ring_.points[ring_.after(out)], vertex);
  Event event = in_ends != out_ends ? pass(in_ends ? in : out, in_ends ? out : in)
                : in_ends           ? end(in, out)
                                    : start(in, out);
  event.vertex = out;
  if (crossing_) return std::nullopt;
  return event;
}

RingSweep::Event RingSweep::start(Index in, Index out) {
  const Vec2& vertex = ring_.points[out];
  const auto above = order_.lower_bound(vertex);
  if (above != order_.end() && ring_.side(above->edge, vertex) == Sign::zero)
    meet(above->edge, out);
  const Sign turn = orientation(vertex, ring_.right(in), ring_.right(out));
  if (turn == Sign::zero) meet(in, out);
  if (crossing_) return {};
  const Index lower = turn == Sign::positive ? in : out, upper = in + out - lower;
  places_[upper] = order_.insert(above, Met{upper});
  places_[lower] = order_.insert(places_[upper], Met{lower});
  check(places_[lower]);
  check(above);
  return {Event::Kind::start, out, lower, upper, below(places_[lower])};
}

RingSweep::Event RingSweep::pass(Index before, Index after) {
  const auto place = places_[after] = places_[before];
  place->edge = after;
  check(place);
  check(std::next(place));
  return {Event::Kind::pass, kNone, before, after, below(place)};
}

// Between the two there is nothing: it would have met one of them.
RingSweep::Event RingSweep::end(Index in, Index out) {
  const auto after_in = std::next(places_[in]);
  const bool in_lower = after_in != order_.end() && after_in->edge == out;
  const auto lower = places_[in_lower ? in : out], upper = places_[in_lower ? out : in];
  const Event event{Event::Kind::end, out, lower->edge, upper->edge, below(lower)};
  order_.erase(lower);
  check(order_.erase(upper));
  return event;
}

RingSweep::Index RingSweep::below(Order::iterator edge) const {
  return edge == order_.begin() ? kNone : std::prev(edge)->edge;
}

// Whether an edge comes to meet the one below it. So far it is above it: it is as long as it is so
// at the nearer of the two right ends.
void RingSweep::check(Order::iterator place) {
  if (place == order_.end() || place == order_.begin() || crossing_) return;
  const Index upper = place->edge, lower = below(place);
  if (ring_.after(lower) == upper || ring_.after(upper) == lower) return;
  const Vec2 &end = ring_.right(lower), &other = ring_.right(upper);
  const bool apart = is_before(end, other) ? ring_.side(upper, end) == Sign::negative
                                           : ring_.side(lower, other) == Sign::positive;
  if (!apart) meet(lower, upper);
}

void RingSweep::meet(Index a, Index b) {
  if (!crossing_) crossing_ = {std::min(a, b), std::max(a, b)};
}

}  // namespace flatray
