// What the lanes may be off by of curves (trace/kernels/walk.h) against what they are, as lane_bounds_test.cpp.
#include <gtest/gtest.h>

#include "full_counts.h"
#include "geom/decide.h"
#include "trace/bound_share.h"
#include "trace/cells.h"
#include "trace/kernels/tiers.h"
#include "trace/random_rays.h"

namespace flatray::lanes {
namespace {

#define FLATRAY_LANES 1
namespace curves {
// clang-format off
#include "trace/kernels/single_moves.h"
#include "trace/kernels/group_body.h"
#include "trace/kernels/curve_body.h"
// clang-format on
}  // namespace curves
#undef FLATRAY_LANES

struct CurveShares {
  BoundShare chord{"a chord's square", 0.05}, hit{"t of a curve", 0.02},
      part{"a place on a part", 0.01};
  int hits = 0, misses = 0;
};

// Of points as seen from the centre, the curve being the unit circle in it.
struct UnitForm {
  const Ellipse& curve;
  Vec2 operator()(const Vec2& w) const {
    return Vec2(cross(w, curve.v), cross(curve.u, w)) / cross(curve.u, curve.v);
  }
};

// An ellipse, whole or in part, or a circle, and a ray to its border, near a tangent or near an end.
struct Curved {
  Arc wall{Ellipse(), Arc::Extent::whole, {0, 0}, {0, 0}};
  Ray ray;

  explicit Curved(Draws& draw) {
    const Vec2 u = draw.unit() * (draw.point() - Vec2(0.5, 0.5));
    const Vec2 v =
        draw.whole(0, 2) == 0 ? Vec2(draw.point() - Vec2(0.5, 0.5)) : Vec2(-u.y(), u.x());
    wall.curve = draw.whole(0, 2) == 0 ? Ellipse(Circle{draw.point(), 0.5 * draw.unit()})
                                       : Ellipse(draw.point(), u, v);
    const double from = 6.3 * draw.unit(), to = from + 6.2 * draw.unit() + 0.05;
    if (draw.whole(0, 2) == 0) {
      const bool turns_left = cross(wall.curve.u, wall.curve.v) > 0;
      wall = {wall.curve, Arc::Extent::between, at(turns_left ? from : to),
              at(turns_left ? to : from)};
    } else if (draw.whole(0, 2) == 0) {
      wall = {wall.curve, Arc::Extent::half, draw.point() - Vec2(0.5, 0.5), {0, 0}};
    }
    const double angle =
        draw.whole(0, 1) == 0 ? from + std::ldexp(1, -draw.whole(8, 24)) : 6.3 * draw.unit();
    const Vec2 point = at(angle), along = at(angle + 1e-3) - point;
    Vec2 way = draw.point() - Vec2(0.5, 0.5);
    if (draw.whole(0, 1) == 0) way = along / along.norm() + std::ldexp(1, -draw.whole(4, 20)) * way;
    const double off = draw.whole(0, 1) == 0 ? 0 : std::ldexp(1, -draw.whole(6, 24));
    ray = {point + off * (point - wall.curve.centre) - draw.unit() * way, way};
  }
  Vec2 at(double angle) const {
    return wall.curve.centre + std::cos(angle) * wall.curve.u + std::sin(angle) * wall.curve.v;
  }
};

// The wall alone in the cells of a room of segments' size, as the kernels have both.
void see_curve(const Curved& given, int cells, CurveShares& shares) {
  Surfaces walls;
  walls.add(given.wall);
  for (int i = 0; i < cells; ++i)
    walls.add(Circle{{i % 7 / 6.0, i % 5 / 4.0}, 0.001 + 0.01 * (i % 3)});
  const CellGrid grid = *CellGrid::build_of_curves(walls);
  const Grid view = grid.view();
  const Curve& curve = view.curves[0];
  const Vec2 from = grid.place(given.ray.origin);
  const Vec2 way = given.ray.direction.cwiseProduct(grid.scale()).normalized();
  if (curve.doubt != 0 || from.cwiseAbs().maxCoeff() > view.half_x) return;
  curves::Asked g{};
  g.ox = static_cast<float>(from.x()), g.oy = static_cast<float>(from.y());
  g.dx = static_cast<float>(way.x()), g.dy = static_cast<float>(way.y());
  const curves::Curves w = curves::spread_curve(curve);
  const curves::Constants c = curves::constants_of(view);
  const curves::Chord o = curves::chord_of(c, w, g);

  const Vec2& scale = grid.scale();
  const Ellipse placed{grid.place(given.wall.curve.centre), given.wall.curve.u.cwiseProduct(scale),
                       given.wall.curve.v.cwiseProduct(scale)};
  const UnitForm form{placed};
  const double r = static_cast<double>(curve.radius);
  const Vec2 p = r * form(placed.centre - from), d = r * form(way);
  const double a = d.squaredNorm(), k = cross(d, p), q = r * r * a - k * k;
  shares.chord.see(static_cast<double>(o.q) - q, static_cast<double>(o.off));
  if (!(o.off < o.q)) {
    shares.misses += q < 0 ? 1 : 0;
    return;
  }
  for (const float side : {-1.0F, 1.0F}) {
    const double exact = (d.dot(p) + static_cast<double>(side) * std::sqrt(q)) / a;
    const curves::Meeting met = curves::meeting(c, w, o, side * o.h, false);
    const double low = static_cast<double>(met.low), high = static_cast<double>(met.high);
    shares.hit.see(exact - 0.5 * (low + high), 0.5 * (high - low));
    const Vec2 place = exact * d - p;
    const double inside = place.x() * static_cast<double>(curve.middle_x) +
                          place.y() * static_cast<double>(curve.middle_y) -
                          r * static_cast<double>(curve.cut);
    const double off = 0.5 * (high - low) + static_cast<double>(c.part);
    const float t = (o.b + side * o.h) * o.inverse;
    shares.part.see(static_cast<double>(curves::inside_of(w, o, t)) - inside, off);
    ++shares.hits;
  }
}

TEST(ErrorBounds, OfLanesHoldForCurves) {
  Draws draw(92);
  CurveShares shares;
  const int count = static_cast<int>(times(10'000));
  for (int i = 0; i < count; ++i) see_curve(Curved(draw), 20 + i % 7 * 40, shares);
  EXPECT_GT(10 * shares.hits, 3 * count);
  EXPECT_GT(100 * shares.misses, 3 * count);
  for (const BoundShare& share : {shares.chord, shares.hit, shares.part}) share.expect_told();
}

}  // namespace
}  // namespace flatray::lanes
