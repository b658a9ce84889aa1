// The diffusion coefficient of the triangular Lorentz gas, discs of radius 1 and a gap between them, by
// nothing but textbook formulas in plain doubles: a ray among the discs of the whole plane, without a cell,
// from the mean square displacement of independent orbits at two times alone.
//   lorentz_diffusion GAP ORBITS SEED
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace {

// SplitMix64 (Steele, Lea and Flood 2014).
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : state_(seed) {}
  double operator()() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return static_cast<double>((z ^ (z >> 31)) >> 11) / 9007199254740992.0;
  }

 private:
  std::uint64_t state_;
};

struct Plane {
  double spacing;
  double x(int i, int j) const { return spacing * (i + 0.5 * j); }
  double y(int j) const { return spacing * std::sqrt(0.75) * j; }
};

struct Walker {
  double x, y, u, v;
  int row, column;  // of the disc left, or near
};

// Flies to the next disc, or for `most` if that is sooner; what was flown.
double fly(const Plane& plane, Walker& at, bool on_disc, double most) {
  constexpr int kReach = 4;  // discs that a free flight can pass, with a finite horizon
  double first = 1e300;
  int to_row = 0, to_column = 0;
  for (int j = at.row - kReach; j <= at.row + kReach; ++j)
    for (int i = at.column - kReach; i <= at.column + kReach; ++i) {
      if (on_disc && i == at.column && j == at.row) continue;
      const double dx = at.x - plane.x(i, j), dy = at.y - plane.y(j);
      const double b = dx * at.u + dy * at.v, side = dx * at.v - dy * at.u;
      if (b >= 0 || side * side >= 1) continue;
      const double t = -b - std::sqrt(1 - side * side);
      if (t < first) {
        first = t;
        to_row = j;
        to_column = i;
      }
    }
  if (first >= most) {
    at.x += most * at.u;
    at.y += most * at.v;
    return most;
  }
  at.x += first * at.u;
  at.y += first * at.v;
  double nx = at.x - plane.x(to_column, to_row), ny = at.y - plane.y(to_row);
  const double size = std::hypot(nx, ny);
  nx /= size;
  ny /= size;
  const double turned = 2 * (at.u * nx + at.v * ny);
  at.u -= turned * nx;
  at.v -= turned * ny;
  at.row = to_row;
  at.column = to_column;
  return first;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const double gap = std::atof(argv[1]);
  const long orbits = std::atol(argv[2]);
  Draws unit(std::strtoull(argv[3], nullptr, 10));
  const Plane plane{2 + gap};
  const double early = 40, late = 80;
  double sum = 0, squares = 0;
  for (long n = 0; n < orbits; ++n) {
    Walker at{};
    for (;;) {  // a place in the rhombus of four discs that is in none of them
      const double a = unit(), b = unit();
      at.x = plane.spacing * (a + 0.5 * b);
      at.y = plane.spacing * std::sqrt(0.75) * b;
      bool free = true;
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) free &= std::hypot(at.x - plane.x(i, j), at.y - plane.y(j)) > 1;
      if (free) break;
    }
    const double angle = 2 * std::acos(-1.0) * unit();
    at.u = std::cos(angle);
    at.v = std::sin(angle);
    const double x = at.x, y = at.y;
    double square[2];
    double time = 0;
    bool on_disc = false;
    for (int k = 0; k < 2; ++k) {
      const double end = k == 0 ? early : late;
      while (time < end) {
        const double left = end - time, flown = fly(plane, at, on_disc, left);
        on_disc = on_disc || flown < left;
        time = flown < left ? time + flown : end;
      }
      square[k] = (at.x - x) * (at.x - x) + (at.y - y) * (at.y - y);
    }
    const double d = (square[1] - square[0]) / (4 * (late - early));
    sum += d;
    squares += d * d;
  }
  const auto count = static_cast<double>(orbits);
  const double mean = sum / count, variance = squares / count - mean * mean;
  std::printf("gap %g: D = %.6f +- %.6f (standard error, %ld orbits)\n", gap, mean,
              std::sqrt(variance / count), orbits);
}
