#include "oracle/catalogue_parts.h"

namespace flatray::oracle {
namespace {

using Orbits = std::vector<StiffOrbits>;
using End = StiffOrbits::End;

// Directions of one speed a third of a radian apart.
std::vector<Ray> fan(const Vec2& from, int count) {
  std::vector<Ray> rays;
  for (int k = 0; k < count; ++k) rays.push_back({from, on_circle(0.2 + k / 3.0)});
  return rays;
}

// Of chaotic orbits the walls are in order as long as digits are left in doubles.
StiffOrbits stadium(double half, std::uint64_t ordered) {
  const auto end = [&](double x, double from_y) {
    return Arc{Circle{{x, 0}, 1}, Arc::Extent::between, {x, from_y}, {x, -from_y}};
  };
  Surfaces walls = walls_of(Segment{{-half, -1}, {half, -1}}, Segment{{half, 1}, {-half, 1}},
                            end(half, -1), end(-half, 1));
  return {std::move(walls), fan({0.1, 0.2}, 2), 200, End::limit, 200, ordered};
}

StiffOrbits sinai(double radius, std::uint64_t ordered) {
  Surfaces walls = ring_of(kSquare);
  walls.add(Circle{{0.5, 0.5}, radius});
  return {std::move(walls), fan({0.05, 0.04}, 2), 200, End::limit, 200, ordered, 4};
}

// The torus unrolled: one disc in each square, as far as a few bounces lead.
StiffOrbits torus(double radius, std::uint64_t bounces) {
  Surfaces walls;
  for (int x = -5; x <= 5; ++x)
    for (int y = -5; y <= 5; ++y)
      walls.add(Circle{{static_cast<double>(x), static_cast<double>(y)}, radius});
  return {std::move(walls), fan({0.5, 0.45}, 2), bounces, End::open, {}, bounces};
}

Orbits mean_free_paths() {
  return {{ring_of(kSquare), fan({0.3, 0.2}, 2), 200, End::limit, 200, 100, 4},
          {walls_of(Circle{{0, 0}, 1}), fan({0.3, 0.2}, 2), 200, End::limit, 200, 100},
          stadium(1, 20),
          sinai(0.25, 20),
          torus(0.25, 6)};
}

Orbits there_and_back() {
  const Ray start{{0.1, 0.2}, {0.31, 0.77}};
  StiffOrbits with_disc = sinai(0.25, 20);
  with_disc.starts = {start};
  with_disc.bounces = 20;
  with_disc.count = 20;
  Orbits all = {{ring_of(box(-1, -1, 1, 1)), {start}, 50, End::limit, 50, 50, 4},
                {ring_of(regular(5)), {start}, 50, End::limit, 50, 50, 5},
                {walls_of(Circle{{0, 0}, 1}), {start}, 50, End::limit, 50, 50},
                std::move(with_disc)};
  for (StiffOrbits& orbits : all) orbits.there_and_back = true;
  return all;
}

// On a wall, which it has just left, to either side; in a corner; outside, towards the room.
Orbits bad_starts() {
  return {{ring_of(kSquare), {{{1, 0.5}, {-1, 0.1}}}, 2, End::limit, 2},
          {ring_of(kSquare), {{{1, 0.5}, {1, 0.1}}}, 2, End::escape, 0},
          {ring_of(kSquare), {{{1, 1}, {-1, -0.5}}}, 2, End::corner, 0},
          {ring_of(kSquare), {{{-1, 0.5}, {1, 0.1}}}, 2, End::escape, 1}};
}

Orbits grazing_starts() {
  return {{ring_of(kSquare), {{{1, 0.5}, {0, 1}}, {{1, 0.5}, {0, -1}}}, 5, End::along, 0},
          {walls_of(Circle{{0, 0}, 1}), {{{0, 1}, {1, 0}}}, 5, End::escape, 0}};
}

}  // namespace

std::vector<StiffCase> stiff_rooms() {
  return {
      of("C19", "mean free path", "study.StiffCases.C19MeanFreePath", mean_free_paths()),
      of("C20", "Lyapunov exponent, stadium", "study.StiffCases.C20LyapunovOfTheStadium",
         {stadium(0.5, 20), stadium(1, 20), stadium(2, 20)}),
      of("C21", "Lyapunov exponent, Sinai torus", "study.StiffCases.C21LyapunovOfTheTorus",
         {torus(0.1, 4), torus(0.25, 6), torus(0.4, 8)}),
      of("C22", "box is torus", "study.StiffCases.C22LyapunovOfTheBox",
         {sinai(0.25, 20), sinai(0.4, 12)}),
      of("C23", "reversal", "transport.StiffCases.C23Reversal", there_and_back()),
      of("C29", "starts badly", "transport.StiffCases.C29StartsBadly", bad_starts()),
      of("C30", "grazing start", "transport.StiffCases.C30GrazingStart", grazing_starts()),
  };
}

}  // namespace flatray::oracle
