#include "geom/reflect.h"

#include <cmath>

#include "geom/decide.h"
#include "geom/quick_hit.h"

namespace flatray {

Vec2 reflect(const Vec2& direction, const Vec2& along) {
  const double dx = direction.x(), dy = direction.y(), ex = along.x(), ey = along.y();
  // 0 - x, because -x of 0 is -0.
  if (ey == 0) return {dx, 0 - dy};
  if (ex == 0) return {0 - dx, dy};
  if (ex == ey) return {dy, dx};
  if (ex == -ey) return {0 - dy, 0 - dx};
  if (const Vec2 quick = quick_reflection(direction, along); !std::isnan(quick.x())) return quick;
  // By twice the angle of the line, c = (ex^2 - ey^2) / e.e and s = 2 ex ey / e.e.
  const auto component = [&](double with_c, double with_s) {
    return round_once([&](const auto& number) {
      const auto x = number(ex), y = number(ey), x2 = x * x, y2 = y * y;
      return (number(with_c) * (x2 - y2) + number(with_s) * number(2.0) * x * y) / (x2 + y2);
    });
  };
  return {component(dx, dy), component(0 - dy, dx)};
}

}  // namespace flatray
