#include "transport/near_doubles.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geom/ray.h"

namespace flatray {
namespace {

constexpr int kSide = 2 * kSearchUlps + 1;

struct Candidate {
  Vec2 point;
  double distance;  // squared, in units of the larger step
};

std::array<Candidate, kSide * kSide> doubles_about(const Vec2& centre) {
  std::array<Candidate, kSide * kSide> all;
  const Vec2 size = centre.cwiseAbs();
  const Vec2 unit(step_ulps(size.x(), 1) - size.x(), step_ulps(size.y(), 1) - size.y());
  const double larger = unit.maxCoeff();
  auto next = all.begin();
  for (int j = -kSearchUlps; j <= kSearchUlps; ++j)
    for (int i = -kSearchUlps; i <= kSearchUlps; ++i) {
      const double x = i * (unit.x() / larger), y = j * (unit.y() / larger);
      *next++ = {{step_ulps(centre.x(), i), step_ulps(centre.y(), j)}, x * x + y * y};
    }
  std::stable_sort(all.begin(), all.end(),
                   [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
  return all;
}

}  // namespace

double step_ulps(double x, int ulps) {
  const double towards = ulps < 0 ? -kInfinity : kInfinity;
  for (int i = std::abs(ulps); i > 0; --i) x = std::nextafter(x, towards);
  return x;
}

std::optional<Vec2> nearest_double(const Vec2& centre,
                                   const std::function<bool(const Vec2&)>& accepted) {
  if (accepted(centre)) return centre;
  for (const Candidate& candidate : doubles_about(centre))
    if (accepted(candidate.point)) return candidate.point;
  return std::nullopt;
}

}  // namespace flatray
