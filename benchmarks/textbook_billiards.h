#pragma once
#include <cmath>

// Billiards as a textbook has them: a loop a room in plain doubles, one orbit after the other, no more
// than each room needs. What has just been left is passed over by a smallest time. Nothing is put back
// on its wall, and what leaks is lost: the measure of what an orbit costs at least.
namespace bench::textbook {

constexpr double kSoon = 1e-10, kNever = 1e300;

struct Particle {
  double x, y, vx, vy;

  void fly(double t) {
    x += t * vx;
    y += t * vy;
  }
  /// Off a wall with a normal of any length: were it taken to be 1, errors of the speed would grow from
  /// disc to disc.
  void reflect(double nx, double ny) {
    const double twice = 2 * (vx * nx + vy * ny) / (nx * nx + ny * ny);
    vx -= twice * nx;
    vy -= twice * ny;
  }
};

/// From inside a box about the middle: until x or y is at a side.
inline double time_to_side(double x, double v, double low, double high) {
  return v > 0 ? (high - x) / v : v < 0 ? (low - x) / v : kNever;
}
/// From outside a disc.
inline double time_to_disc(const Particle& p, double cx, double cy, double r) {
  const double x = p.x - cx, y = p.y - cy;
  const double b = x * p.vx + y * p.vy, c = x * x + y * y - r * r, q = b * b - c;
  if (b >= 0 || q < 0) return kNever;
  const double t = -b - std::sqrt(q);
  return t > kSoon ? t : kNever;
}

/// Each room flies to its next bounce and gives the length of that flight; 0 once nothing lies ahead.
struct Square {
  double bounce(Particle& p) const {
    const double tx = time_to_side(p.x, p.vx, 0, 1), ty = time_to_side(p.y, p.vy, 0, 1);
    const double t = tx < ty ? tx : ty;
    p.fly(t);
    if (tx < ty)
      p.vx = -p.vx;
    else
      p.vy = -p.vy;
    return t;
  }
};

struct Sinai {
  double bounce(Particle& p) const {
    const double disc = time_to_disc(p, 0.5, 0.5, 0.25);
    if (disc == kNever) return Square().bounce(p);
    p.fly(disc);
    p.reflect(p.x - 0.5, p.y - 0.5);
    return disc;
  }
};

struct Lorentz {
  double bounce(Particle& p) const {
    double flown = 0;
    for (;;) {
      const double disc = time_to_disc(p, 0.5, 0.5, 0.25);
      if (disc != kNever) {
        p.fly(disc);
        p.reflect(p.x - 0.5, p.y - 0.5);
        return flown + disc;
      }
      const double tx = time_to_side(p.x, p.vx, 0, 1), ty = time_to_side(p.y, p.vy, 0, 1);
      const double t = tx < ty ? tx : ty;
      p.fly(t);
      flown += t;
      if (tx < ty)
        p.x = p.vx > 0 ? 0 : 1;
      else
        p.y = p.vy > 0 ? 0 : 1;
    }
  }
};

struct Stadium {  // half circles of radius 1 about (-1, 0) and (1, 0), and y = -1, 1 between them
  double bounce(Particle& p) const {
    const double straight = time_to_side(p.y, p.vy, -1, 1);
    if (straight > kSoon && std::fabs(p.x + straight * p.vx) <= 1) {
      p.fly(straight);
      p.vy = -p.vy;
      return straight;
    }
    const double centre = p.x + straight * p.vx > 1 ? 1 : -1;
    const double x = p.x - centre, b = x * p.vx + p.y * p.vy;
    const double t = -b + std::sqrt(b * b - (x * x + p.y * p.y - 1));
    p.fly(t);
    p.reflect(p.x - centre, p.y);
    return t;
  }
};

struct Ellipse {  // of half-axes 3 and 2
  double bounce(Particle& p) const {
    const double a = p.vx * p.vx / 9 + p.vy * p.vy / 4, b = p.x * p.vx / 9 + p.y * p.vy / 4;
    const double c = p.x * p.x / 9 + p.y * p.y / 4 - 1;
    const double t = (-b + std::sqrt(b * b - a * c)) / a;
    p.fly(t);
    p.reflect(p.x / 9, p.y / 4);
    return t;
  }
};

struct ThreeDiscs {  // of radius 1, their centres 2.5 apart
  static constexpr double kCentres[3][2] = {
      {1.4433756729740643, 0}, {-0.7216878364870322, 1.25}, {-0.7216878364870322, -1.25}};
  double bounce(Particle& p) const {
    double t = kNever;
    int disc = 0;
    for (int i = 0; i < 3; ++i)
      if (const double ti = time_to_disc(p, kCentres[i][0], kCentres[i][1], 1); ti < t)
        t = ti, disc = i;
    if (t == kNever) return 0;
    p.fly(t);
    p.reflect(p.x - kCentres[disc][0], p.y - kCentres[disc][1]);
    return t;
  }
};

}  // namespace bench::textbook
