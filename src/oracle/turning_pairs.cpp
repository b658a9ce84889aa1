#include "oracle/turning_pairs.h"

#include <numbers>

#include "base/portable_math.h"

namespace flatray::oracle {
namespace {

double between(Draw& draw, double low, double high) { return low + (high - low) * draw.unit(); }
Vec2 on_circle(double angle) { return {portable::cos(angle), portable::sin(angle)}; }

// Corners on an ellipse, so convex, about a point that may lie beside it.
std::vector<Vec2> drawn_ring(Draw& draw, int corners, double flat) {
  const double size = between(draw, 0.2, 1), first = draw.unit(), off_x = draw.unit(),
               off_y = draw.unit();
  const bool centred = draw.unit() < 0.5;
  std::vector<Vec2> ring;
  for (int i = 0; i < corners; ++i) {
    const double part = (i + first + 0.8 * draw.unit()) / corners;
    const Vec2 p = on_circle(2 * std::numbers::pi * part);
    ring.emplace_back(size * p.x(), size * flat * p.y());
    if (!centred) ring.back() += Vec2(off_x - 0.5, off_y - 0.5);
  }
  return ring;
}

// Two that fly at each other or past.
TurningPair aimed(Draw& draw, std::vector<Vec2> ring_a, std::vector<Vec2> ring_b,
                  double most_spin) {
  const double around = 2 * std::numbers::pi * draw.unit(), distance = between(draw, 0.5, 4);
  const double miss = between(draw, -2, 2), speed = between(draw, 0, 8);
  const Vec2 from = on_circle(around), beside(-from.y(), from.x());
  const double angle_a = between(draw, -4, 4), angle_b = between(draw, -4, 4);
  const double spin_a = between(draw, -most_spin, most_spin);
  const double spin_b = draw.unit() < 0.3 ? 0 : between(draw, -most_spin, most_spin);
  const double x = between(draw, -3, 3), y = between(draw, -3, 3);
  const Vec2 at(x, y), way = -speed * from;
  return {{std::move(ring_a), 0, at, {0.5, -0.25}, angle_a, spin_a},
          {std::move(ring_b), 0, at + distance * from + miss * beside, way, angle_b, spin_b}};
}

TurningPair cornered(Draw& draw, int least_a, int least_b, double flat, double most_spin) {
  const int m = draw.whole(least_a, least_a + 5), n = draw.whole(least_b, least_b + 5);
  auto one = drawn_ring(draw, m, flat), other = drawn_ring(draw, n, flat);
  return aimed(draw, std::move(one), std::move(other), most_spin);
}

TurningPair polygons(Draw& draw) { return cornered(draw, 3, 3, 1, 6); }
TurningPair fast(Draw& draw) { return cornered(draw, 2, 3, 0.5, 80); }

TurningPair rounded(Draw& draw) {
  TurningPair pair = cornered(draw, 1, 1, 1, 6);
  pair.a.radius = draw.unit() < 0.3 ? 0 : between(draw, 0.01, 0.5);
  pair.b.radius = between(draw, 0.01, 0.5);
  return pair;
}

TurningPair slivers(Draw& draw) {
  const int m = draw.whole(3, 8), n = draw.whole(3, 8);
  const double thin = draw.halves(30);
  auto one = drawn_ring(draw, m, thin), other = drawn_ring(draw, n, 1);
  return aimed(draw, std::move(one), std::move(other), 6);
}

TurningPair segments(Draw& draw) {
  auto one = drawn_ring(draw, 2, 1), other = drawn_ring(draw, draw.whole(2, 4), 1);
  return aimed(draw, std::move(one), std::move(other), 6);
}

TurningPair far_pair(Draw& draw) {
  TurningPair pair = polygons(draw);
  const double x = draw.sign() * 0x1p20, y = draw.sign() * 0x1p20;
  pair.a.at += Vec2(x, y);
  pair.b.at += Vec2(x, y);
  return pair;
}

// Squares of whole numbers that meet side to side, corner to corner or corner to side.
TurningPair squares(Draw& draw) {
  const double half_a = 1 + draw.below(2), half_b = 1 + draw.below(2);
  const auto square = [](double h) {
    return std::vector<Vec2>{{-h, -h}, {h, -h}, {h, h}, {-h, h}};
  };
  const double turn_a = draw.below(5), turn_b = draw.below(5);
  const double spin_a = draw.below(5) - 2, spin_b = draw.below(3) - 1;
  const double x = 3 + draw.below(3), y = draw.below(3), way = draw.below(6);
  constexpr double kEighth = std::numbers::pi / 4;
  return {{square(half_a), 0, {0, 0}, {0, 0}, turn_a * kEighth, spin_a * kEighth},
          {square(half_b), 0, {x, y}, {-way, 0}, turn_b * kEighth, spin_b * kEighth}};
}

// A corner passes a side by 2^-k of a unit, or into it: the arm of a turning body is that much
// longer or shorter than its way to a wall.
TurningPair grazing(Draw& draw) {
  const double arm = between(draw, 0.5, 2), turned = between(draw, -1, 1);
  const double part = draw.halves(36), off = draw.sign() * 0x1p-4 * part;
  const double angle = 2 * std::numbers::pi * draw.unit(), spin = between(draw, 2.5, 6);
  const Vec2 across = on_circle(angle), along(-across.y(), across.x());
  const double wall = arm + off;
  const std::vector<Vec2> hand = {{-0.25, -0.125}, {arm, 0}, {-0.25, 0.125}},
                          side = {{0, -2}, {1, -2}, {1, 2}, {0, 2}};
  return {{hand, 0, {0, 0}, 0.1 * turned * along, angle - 0.5 * spin, spin},
          {side, 0, wall * across, {0, 0}, angle, 0}};
}

constexpr TurningFamily kFamilies[] = {
    {"turning-polygons", &polygons, 1000}, {"turning-rounded", &rounded, 1001},
    {"turning-slivers", &slivers, 1002},   {"turning-segments", &segments, 1003},
    {"turning-fast", &fast, 1004},         {"turning-far", &far_pair, 1005},
    {"turning-squares", &squares, 1006},   {"turning-grazing", &grazing, 1007}};

}  // namespace

std::span<const TurningFamily> turning_families() { return kFamilies; }

}  // namespace flatray::oracle
