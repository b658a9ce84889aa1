#include "geom/arc.h"

#include "geom/decide.h"

namespace flatray {

Sign curve_side(const Vec2& point, const Ellipse& curve) {
  return decide([&](const auto& number) {
    return curve_power(number, curve, pair_of(number, point) - pair_of(number, curve.centre));
  });
}

// By their centres and by u u' + v v', which no change of conjugate half-diameters moves.
bool is_same_curve(const Ellipse& a, const Ellipse& b) {
  if (a.centre != b.centre) return false;
  const auto is_same = [&](int i, int j) {
    return decide([&](const auto& number) {
             const auto form = [&](const Ellipse& curve) {
               return number(curve.u[i]) * number(curve.u[j]) +
                      number(curve.v[i]) * number(curve.v[j]);
             };
             return form(a) - form(b);
           }) == Sign::zero;
  };
  return (a.u == b.u && a.v == b.v) || (is_same(0, 0) && is_same(0, 1) && is_same(1, 1));
}

ArcPlace place_on(const Arc& arc, const Vec2& point) {
  const Vec2& centre = arc.curve.centre;
  const Sign side = curve_side(point, arc.curve);
  if (side == Sign::zero) return place_in_cone(arc, point);
  if (arc.extent != Arc::Extent::between) return ArcPlace::outside;
  // What joins an end e to the curve: from e on, towards the curve and no farther.
  for (const Vec2& end : {arc.from, arc.to}) {
    if (curve_side(end, arc.curve) != side || orientation(centre, end, point) != Sign::zero)
      continue;
    const Sign ahead = decide([&](const auto& number) {
      const auto e = pair_of(number, end) - pair_of(number, centre);
      return dot(pair_of(number, point) - pair_of(number, end), e);
    });
    const Sign before = decide([&](const auto& number) {
      const auto e = pair_of(number, end) - pair_of(number, centre);
      return dot(pair_of(number, point) - pair_of(number, centre), e);
    });
    if (before == Sign::positive && ahead != side) return ArcPlace::at_end;
  }
  return ArcPlace::outside;
}

// The reach along an axis is sqrt(u_i^2 + v_i^2), below |u_i| + |v_i|, neither of which overflows
// before the other by more than a factor of 2; four roundings, and one of the sum with the centre.
Bounds curve_bounds(const Ellipse& curve) {
  constexpr double kUp = 1 + 0x1p-49;
  Bounds box;
  for (int axis = 0; axis < 2; ++axis) {
    const double a = std::fabs(curve.u[axis]), b = std::fabs(curve.v[axis]);
    const double larger = std::max(a, b), ratio = larger == 0 ? 0 : std::min(a, b) / larger;
    const double reach = larger * std::sqrt(1 + ratio * ratio) * kUp + 0x1p-1070;
    const double most = std::numeric_limits<double>::max();
    box.low[axis] = std::max(std::nextafter(curve.centre[axis] - reach, -kInfinity), -most);
    box.high[axis] = std::min(std::nextafter(curve.centre[axis] + reach, kInfinity), most);
  }
  return box;
}

}  // namespace flatray
