#pragma once
#include <numbers>

#include "base/portable_math.h"
#include "geom/polygon.h"
#include "oracle/catalogue.h"

namespace flatray::oracle {

/// What several parts of the catalogue are made of.
using Ring = std::vector<Vec2>;
constexpr double kTurn = 2 * std::numbers::pi;

inline Ring box(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}
inline const Ring kSquare = box(0, 0, 1, 1);

inline Vec2 on_circle(double angle) { return {portable::cos(angle), portable::sin(angle)}; }
inline Ring regular(int sides) {
  Ring ring;
  for (int i = 0; i < sides; ++i) ring.push_back(on_circle(kTurn * i / sides));
  return ring;
}

inline void add_ring(Surfaces& walls, const Ring& ring) {
  for (const Segment& wall : ring_edges(ring)) walls.add(wall);
}
inline Surfaces ring_of(const Ring& vertices) {
  Surfaces walls;
  add_ring(walls, vertices);
  return walls;
}
template <class... Walls>
Surfaces walls_of(const Walls&... each) {
  Surfaces walls;
  (walls.add(each), ...);
  return walls;
}

inline StiffCase of(const char* id, const char* words, const char* test,
                    std::vector<StiffOrbits> orbits) {
  return {id, words, test, {}, std::move(orbits)};
}
inline StiffCase of(const char* id, const char* words, const char* test,
                    std::vector<StiffContact> contacts) {
  return {id, words, test, {}, {}, std::move(contacts)};
}

template <class Part>
std::vector<Part> operator+(std::vector<Part> a, const std::vector<Part>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace flatray::oracle
