#include "geom/reflect.h"

#include "geom/decide.h"

namespace flatray {

Vec2 reflect(const Vec2& direction, const Vec2& along) {
  const double dx = direction.x(), dy = direction.y(), ex = along.x(), ey = along.y();
  // 0 - x, because -x of 0 is -0.
  if (ey == 0) return {dx, 0 - dy};
  if (ex == 0) return {0 - dx, dy};
  if (ex == ey) return {dy, dx};
  if (ex == -ey) return {0 - dy, 0 - dx};
  return round_both([&](const auto& number) {
    const auto d = pair_of(number, direction), e = pair_of(number, along);
    return (dot(d, e) / dot(e, e) * 2) * e - d;
  });
}

}  // namespace flatray
