#include "geom/turn.h"

#include <cmath>
#include <optional>

#include "base/portable_math.h"
#include "geom/ray.h"

namespace flatray {
namespace {

// pi/2 = kQuarterHigh + kQuarterLow to 107 bits.
constexpr double kQuarterHigh = 0x1.921fb54442d18p+0, kQuarterLow = 0x1.1a62633145c07p-54;

// Number of quarter turns in `angle` if it is within 1 ulp of a whole number of them.
std::optional<double> quarter_turns(double angle) {
  const double turns = std::floor(angle / kQuarterHigh + 0.5);
  const double high = turns * kQuarterHigh;
  const double rest = std::fma(turns, kQuarterHigh, -high) + turns * kQuarterLow;
  const double nearest = high + rest;  // turns * pi/2, rounded
  if (angle >= std::nextafter(nearest, -kInfinity) && angle <= std::nextafter(nearest, kInfinity))
    return turns;
  return std::nullopt;
}

}  // namespace

Turn turn(double angle) {
  if (const std::optional<double> turns = quarter_turns(angle)) {
    constexpr Turn kQuarters[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    return kQuarters[static_cast<int>(*turns - 4 * std::floor(*turns / 4))];  // exact: 0 to 3
  }
  return {portable::cos(angle), portable::sin(angle)};
}

}  // namespace flatray
