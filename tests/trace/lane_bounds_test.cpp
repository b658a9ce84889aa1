// What the lanes of the grid and of contacts may be off by (trace/kernels/walk.h, geom/error_bounds.h) against what they
// are: with the records and rays of the kernels, and truth in doubles, whose own errors are 2^-29 of these bounds.
#include <gtest/gtest.h>

#include "full_counts.h"
#include "geom/error_bounds.h"
#include "geom/exact.h"
#include "geom/predicates.h"
#include "trace/bound_share.h"
#include "trace/cells.h"
#include "trace/kernels/tiers.h"
#include "trace/random_rays.h"

namespace flatray::lanes {
namespace {

#define FLATRAY_LANES 1
// clang-format off
#include "trace/kernels/single_moves.h"
#include "trace/kernels/group_body.h"
#include "trace/kernels/judge_body.h"
// clang-format on
#undef FLATRAY_LANES

struct Shares {
  BoundShare side{"the side of an end", 0.25}, time{"t of an end", 0.125}, hit{"t of a hit", 0.125};
  BoundShare end{"t of the end of a ray", 0.125}, place{"a place in the next cell", 0.5};
  BoundShare filter{"a determinant", 0.25};
};

// A ray and the lanes' own.
struct Asking {
  Vec2 from, way;  // in cells, of length 1
  Asked lane{};
  float inverse_x = 0;
};

void see_wall(const Grid& grid, const Asking& ray, const Segment& wall, const float* record,
              Shares& shares) {
  const Asked& g = ray.lane;
  const Record r = spread_record(record);
  const auto side = [&](const Vec2& end) { return cross(ray.way, Vec2(end - ray.from)); };
  const auto time = [&](const Vec2& end) { return ray.way.dot(end - ray.from); };
  const Float ax = r.ax - g.ox, ay = r.ay - g.oy, bx = r.bx - g.ox, by = r.by - g.oy;
  const double unit = static_cast<double>(grid.unit), s_a = side(wall.a), s_b = side(wall.b),
               t_a = time(wall.a), t_b = time(wall.b);
  const auto wide = [](float x) { return static_cast<double>(x); };
  shares.side.see(wide(fused_difference(g.dx, ay, g.dy * ax)) - s_a, kSide * unit);
  shares.side.see(wide(fused_difference(g.dx, by, g.dy * bx)) - s_b, kSide * unit);
  shares.time.see(wide(fused(g.dx, ax, g.dy * ay)) - t_a, kTime * unit);
  shares.time.see(wide(fused(g.dx, bx, g.dy * by)) - t_b, kTime * unit);
  Asked asked = g;
  judge<false>(constants_of(grid), r, none(), asked);
  if (asked.best == kNoRecord) return;
  const double low = wide(asked.low), high = wide(asked.high);
  shares.hit.see(t_a + s_a * (t_b - t_a) / (s_a - s_b) - (low + high) / 2, (high - low) / 2);
}

// Where it leaves the column it is in, and kNear u M before, seen from the cell behind: as advance() has it.
void see_place(const Grid& grid, const Asking& ray, Shares& shares) {
  const Asked& g = ray.lane;
  const float from_x = turned_by(g.dx, g.ox), from_y = turned_by(g.dy, g.oy);
  for (float exit_x = floor(from_x) + 1; static_cast<double>(exit_x) < grid.half_x; ++exit_x) {
    const float exit = (exit_x - from_x) * ray.inverse_x, y = fused(exit, size(g.dy), from_y);
    if (std::fabs(static_cast<double>(y)) > grid.half_y) return;
    const double unit = static_cast<double>(grid.unit),
                 t = static_cast<double>(exit) - kNear * unit;
    const Vec2 at =
        (ray.from + t * ray.way).cwiseProduct(Vec2(g.dx < 0 ? -1 : 1, g.dy < 0 ? -1 : 1));
    shares.place.see(at.x() - static_cast<double>(exit_x), kMargin * unit);
    shares.place.see(at.y() - static_cast<double>(y), kMargin * unit);
  }
}

// Walls that rays from `from` run along but for some 2^-10 to 2^-22 of the room, or meet anyhow.
struct Room {
  std::vector<Vec2> from;
  Surfaces walls;
  Room(Draws& draw, int count) {
    for (int i = 0; i < count; ++i) {
      from.push_back(draw.point());
      const Vec2 a = draw.point(), off = std::ldexp(1, -draw.whole(10, 22)) * (draw.point() - a);
      const Vec2 b =
          i % 4 == 0 ? draw.point() : Vec2(from.back() + draw.unit() * (a - from.back()));
      walls.add(Segment{a, b + off});
    }
  }
};

void see_room(const Room& room, Draws& draw, Shares& shares) {
  const CellGrid cells = *CellGrid::build(room.walls);
  const Grid grid = cells.view();
  for (std::size_t i = 0; i < room.from.size(); ++i) {
    const Segment& along = room.walls.segments[i];
    const Vec2 from = room.from[i], way = along.a - from;
    const double up_to = draw.unit();
    float ox, oy, dx, dy, inverse_x, inverse_y, end_low, end_high;
    Walking walking{};
    walking.ox = &ox, walking.oy = &oy, walking.dx = &dx, walking.dy = &dy;
    walking.inverse_x = &inverse_x, walking.inverse_y = &inverse_y;
    walking.up_to = &up_to, walking.end_low = &end_low, walking.end_high = &end_high;
    walking.count = 1;
    int fate = 0;
    const double given[] = {from.x(), from.y(), way.x(), way.y()};
    lane_kernels(Isa::portable)
        .walk.prepare(grid, {given, given + 1, given + 2, given + 3, 1}, walking, &fate);
    const Vec2 in_cells = way.cwiseProduct(cells.scale());
    const Vec2 place = cells.place(from);
    if (std::fabs(place.x()) >= grid.half_x || std::fabs(place.y()) >= grid.half_y) continue;
    const double low = static_cast<double>(end_low), high = static_cast<double>(end_high);
    shares.end.see(up_to * in_cells.norm() - (low + high) / 2, (high - low) / 2);
    Asking ray{place, in_cells.normalized()};
    walking.up_to = nullptr;
    load_rays(walking, 0, ray.lane);
    ray.inverse_x = inverse_x;
    see_place(grid, ray, shares);
    const float* record = grid.records;
    for (const unsigned* slot = grid.slots; slot != grid.slots + room.from.size();
         ++slot, record += 4) {
      const Segment& wall = room.walls.segments[*slot];
      see_wall(grid, ray, {cells.place(wall.a), cells.place(wall.b)}, record, shares);
    }
  }
}

// As side() of collide/kernels/certify_body.h has it, of points on lines that all but agree.
void see_filter(Draws& draw, BoundShare& share) {
  const auto point = [&] { return Vec2(draw.spread(-2, 2), draw.spread(-2, 2)); };
  const Vec2 p = point(), q = point(), r = point();
  const Vec2 s = draw.bits() % 2 == 0 ? point() : Vec2(r + 0.7 * (q - p));
  const Vec2 a = q - p, b = s - r;
  const double left = a.x() * b.y(), right = a.y() * b.x();
  const auto step = [](double to, double from) { return Rational(to) - from; };
  const Rational exact =
      step(q.x(), p.x()) * step(s.y(), r.y()) - step(q.y(), p.y()) * step(s.x(), r.x());
  share.see((exact - (left - right)).nearest(), kDetFilter * (std::fabs(left) + std::fabs(right)));
}

TEST(ErrorBounds, OfLanesHold) {
  Draws draw(91);
  Shares shares;
  for (int count = 20; count < 1000; count += kSanitized ? 240 : 20)
    see_room(Room(draw, count), draw, shares);
  for (std::uint64_t i = 0; i < times(10'000); ++i) see_filter(draw, shares.filter);
  for (const BoundShare& share :
       {shares.side, shares.time, shares.hit, shares.end, shares.place, shares.filter})
    share.expect_told();
}

}  // namespace
}  // namespace flatray::lanes
