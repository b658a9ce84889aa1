#include <cmath>
#include <optional>
#include <tuple>

#include "collide/contact.h"
#include "collide/minkowski.h"
#include "geom/decide.h"
#include "geom/pair.h"

namespace flatray {
namespace {

const Vec2& vertex(const MovingBody& body, int k) {
  return body.vertices[static_cast<std::size_t>(k)];
}

// Whither b goes as seen from a, also where the way is beyond the doubles.
Vec2 heading(const MovingBody& a, const MovingBody& b) {
  const Vec2 way = b.velocity - a.velocity;
  return unit(way.allFinite() ? way : 0.5 * b.velocity - 0.5 * a.velocity);
}
Vec2 turned_right(const Vec2& along) { return unit({along.y(), -along.x()}); }

// Of an edge of positive length; of a core without area any tells the line.
Vec2 edge_normal(std::span<const Vec2> ring, std::size_t edge) {
  std::size_t end = edge;
  do end = end + 1 == ring.size() ? 0 : end + 1;
  while (ring[end] == ring[edge] && end != edge);
  return turned_right(ring[end] - ring[edge]);
}

// The normal between two discs about vertices where they first touch: by how far they would pass each
// other, not by places at a rounded time, which far from the origin tell nothing.
Vec2 normal_of_discs(const Vec2& at_a, const MovingBody& a, const Vec2& at_b, const MovingBody& b) {
  const auto from = [&](const auto& number) {
    return pair_of(number, at_b) - pair_of(number, at_a);
  };
  const auto way = [&](const auto& number) {
    return pair_of(number, b.velocity) - pair_of(number, a.velocity);
  };
  const auto share = [&](bool squared_miss) {
    return round_once([&](const auto& number) {
      const auto radius = number(a.radius) + number(b.radius);
      const auto whole = radius * radius * dot(way(number), way(number));
      const auto across = cross(from(number), way(number));
      return (squared_miss ? across * across : whole - across * across) / whole;
    });
  };
  const Sign beside = decide([&](const auto& number) { return cross(from(number), way(number)); });
  const Vec2 ahead = heading(a, b);
  const double sine = std::sqrt(share(true)) * static_cast<int>(beside);
  return -std::sqrt(share(false)) * ahead - sine * Vec2(-ahead.y(), ahead.x());
}

ContactPlace place_on_a(const MovingBody& a, const Vec2& at, double t, const Vec2& normal) {
  return {at + t * a.velocity + a.radius * normal, normal};
}
ContactPlace place_on_b(const MovingBody& b, const Vec2& at, double t, const Vec2& normal) {
  return {at + t * b.velocity - b.radius * normal, normal};
}

// Orders ways out alike whichever body comes first: the shortest; of equal ones that on which they come
// nearer the fastest; then by the angle of the line they lie on.
std::tuple<double, double, double> rank_of(double length, const Vec2& normal,
                                           const Vec2& velocity) {
  const bool is_down = normal.y() < 0 || (normal.y() == 0 && normal.x() < 0);
  return {length, normal.dot(velocity), is_down ? normal.x() : -normal.x()};
}

}  // namespace

ContactPlace contact_place(const ContactFeature& feature, const MovingBody& a, const MovingBody& b,
                           double t) {
  const auto& [edge_of_a, edge, other, corner] = feature;
  if (edge == kNoEdge) {
    const Vec2 &at_a = vertex(a, corner), &at_b = vertex(b, other);
    return place_on_a(a, at_a, t, normal_of_discs(at_a, a, at_b, b));
  }
  Vec2 normal = edge_normal((edge_of_a ? a : b).vertices, static_cast<std::size_t>(edge));
  // Out of the first: against the way in which it is met.
  if (normal.dot(heading(b, a)) < 0) normal = -normal;
  return edge_of_a ? place_on_b(b, vertex(b, other), t, normal)
                   : place_on_a(a, vertex(a, other), t, normal);
}

ContactPlace resting_place(const MovingBody& a, const MovingBody& b, double t) {
  const Difference difference = minkowski_difference(a.vertices, b.vertices);
  const Vec2 velocity = b.velocity - a.velocity, moved = t * velocity;
  const auto from = [&](const DifferenceCorner& c) -> Vec2 {
    return (b.vertices[c.b] - a.vertices[c.a]) + moved;
  };
  std::optional<ContactPlace> nearest;
  std::tuple least(kInfinity, 0.0, 0.0);
  const std::size_t count = difference.corners.size();
  for (std::size_t k = 0; k < count; ++k) {
    const DifferenceCorner& corner = difference.corners[k];
    const auto& [of_a, of_b, edge_of_a, far, edge] = corner;
    const Vec2 start = from(corner), end = from(difference.corners[k + 1 == count ? 0 : k + 1]);
    const Vec2 outward = count == 1  ? Vec2(0, 0)
                         : edge_of_a ? turned_right(a.vertices[far] - a.vertices[of_a])
                                     : turned_right(b.vertices[of_b] - b.vertices[far]);
    const Vec2 along(-outward.y(), outward.x());
    const bool beside = count > 1 && along.dot(start) >= 0 && along.dot(end) <= 0;
    if (beside && !difference.has_area && outward.dot(start) < 0) continue;  // the side back is
    const double distance = beside ? std::fabs(outward.dot(start)) : start.stableNorm();
    const bool is_corner = !beside && distance > 0;
    const Vec2 normal = is_corner ? unit(start) : outward;
    const auto rank = rank_of(distance, normal, velocity);
    if (!(rank < least)) continue;
    least = rank;
    nearest = !is_corner && edge_of_a ? place_on_b(b, b.vertices[of_b], t, normal)
                                      : place_on_a(a, a.vertices[of_a], t, normal);
  }
  return nearest.value_or(ContactPlace{a.vertices.front(), {0, 0}});
}

ContactPlace first_place(const Contact& met, const MovingBody& a, const MovingBody& b) {
  const double t = met.times.t_enter;
  return met.first ? contact_place(met.first, a, b, t) : resting_place(a, b, t);
}

}  // namespace flatray
