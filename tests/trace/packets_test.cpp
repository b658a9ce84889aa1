// Rays that go together, and so walk as one, against the exact code for every wall, bit for bit.
#include <bit>

#include "trace/cells.h"
#include "trace/crowd.h"

namespace flatray {
namespace {

// By their angle: from one place, or side by side, some of them at ends of walls.
void add_beam(Draws& draw, const Vec2& from, const Vec2& aside, const Vec2& to, Case& c) {
  constexpr int kRays = 256;
  const Vec2 along = to - from;
  const Vec2 spread = 1e-3 * draw.unit() * Vec2(-along.y(), along.x());
  for (int i = 0; i < kRays; ++i) {
    const double turn = 2.0 * i / kRays - 1;
    const Vec2 bend = i % 16 == 5 ? Vec2(0, 0) : Vec2(turn * spread);
    c.rays.add({i % 16 == 5 ? from : Vec2(from + turn * aside), along + bend});
    if (i >= 128 && i % 16 == 9)  // some go astray
      c.rays.set(c.rays.size() - 1, {draw.point(), draw.point() - Vec2(0.5, 0.5)}, {});
  }
}

Case together(Draws& draw, double size) {
  Case c;
  c.walls = crowd(draw, 60, size);
  const Vec2 cluster = draw.point();
  for (int i = 0; i < 300; ++i) {
    const Vec2 at = cluster + 0.01 * draw.point();
    c.walls.add(Segment{at, at + 0.002 * (draw.point() - Vec2(0.5, 0.5))});
  }
  for (int beam = 0; beam < 6; ++beam) {
    const Vec2 inside = draw.point(), outside = Vec2(3, 2) - 4 * draw.point();
    const Vec2 from = beam % 4 == 0 ? any_end(draw, c.walls) : beam % 4 == 1 ? outside : inside;
    const Vec2 to = beam % 3 == 0 ? Vec2(cluster + 0.01 * draw.point()) : any_end(draw, c.walls);
    add_beam(draw, from, {0, 0}, to, c);
    add_beam(draw, inside, {0, 1e-3 * draw.unit()}, to, c);
    const bool level = beam % 2 == 0;  // along an axis, some of them along walls
    add_beam(draw, from, {0, 0}, from + (level ? Vec2(0.5, 0) : Vec2(0, -0.5)), c);
  }
  return c;
}

TEST(Tracers, AgreeOnRaysThatGoTogether) {
  Draws draw(31);
  for (const double size : {0.02, 0.3}) {
    Case c = together(draw, size);
    expect_all_tiers_exact(c);
    for (DepartedSurface& departed : c.rays.departed)
      departed.surface = static_cast<std::uint32_t>(draw.bits() % c.walls.size());
    expect_all_tiers_exact(c);
  }
}

TEST(Tracers, AgreeOnRaysThatGoTogetherAndEnd) {
  Draws draw(32);
  const Case c = together(draw, 0.1);
  std::vector<double> up_to;
  std::vector<std::uint8_t> truth, met(c.rays.size());
  for (std::size_t i = 0; i < c.rays.size(); ++i) {
    const double t = exact_hit_of(c, i).t;
    up_to.push_back(t < kInfinity ? t * (0.5 + draw.unit()) : 10 * draw.unit());
    truth.push_back(t <= up_to.back() ? 1 : 0);
  }
  for (const Tracer* tracer : exact_tracers())
    for (const Isa isa : available_isas()) {
      tracer->build(c.walls, isa)->any(c.rays, up_to, met);
      for (std::size_t i = 0; i < met.size(); ++i)
        ASSERT_EQ(met[i], truth[i])
            << tracer->name << ", " << isa_name(isa) << ", ray " << i << " from "
            << c.rays.ray(i).origin.transpose() << " along " << c.rays.ray(i).direction.transpose()
            << ": wall " << exact_hit_of(c, i).surface << " at " << exact_hit_of(c, i).t
            << ", up to " << up_to[i];
    }
}

// Cells that have cells of their own: column, row, and how many along a side.
std::vector<std::array<int, 3>> crowded_cells(const CellGrid& cells) {
  const lanes::Grid view = cells.view();
  std::vector<std::array<int, 3>> found;
  for (int y = -cells.rows() / 2; y < cells.rows() / 2; ++y)
    for (int x = -cells.columns() / 2; x < cells.columns() / 2; ++x) {
      const auto at = static_cast<std::ptrdiff_t>(view.first) +
                      static_cast<std::ptrdiff_t>(view.stride) * y + x;
      const unsigned word = view.cells[at];
      if ((word >> 30) == 1)
        found.push_back({x, y, static_cast<int>(std::bit_cast<float>(word & 0x7f800000U))});
    }
  return found;
}

// Nearly along an axis within an ulp of a border of such a cell's own cells, where bounds from below and
// from above of equal rays may cross. Found by a reviewer's draws: walls were passed.
TEST(Tracers, AgreeOnEqualRaysAlongBordersOfCrowdedCells) {
  Draws draw(33);
  for (int scene = 0; scene < 12; ++scene) {
    Case c;
    c.walls = crowd(draw, 0, 1);
    const Vec2 cluster = Vec2(0.1, 0.1) + 0.8 * draw.point();
    for (int i = draw.whole(200, 500); i > 0; --i) {
      const Vec2 at = cluster + 0.03 * draw.point();
      c.walls.add(Segment{at, at + 0.004 * draw.unit() * (draw.point() - Vec2(0.5, 0.5))});
    }
    const auto cells = CellGrid::build(c.walls);
    const lanes::Grid view = cells->view();
    const std::vector<std::array<int, 3>> crowded = crowded_cells(*cells);
    ASSERT_FALSE(crowded.empty());
    for (int k = 0; k < 1024; ++k) {
      const auto [x, y, parts] = crowded[draw.bits() % crowded.size()];
      const bool level = draw.whole(0, 1) == 0, back = draw.whole(0, 1) == 0;
      const double border = (level ? y : x) + double(draw.whole(1, parts - 1)) / parts;
      const double ulp = 0x1p-23 * std::max(1.0, std::fabs(border));
      const double rise = draw.unit() * (draw.whole(0, 1) == 0 ? 1 : parts) * ulp *
                          (draw.whole(0, 1) == 0 ? 1 : -1);
      const double away = draw.unit() * (draw.whole(0, 1) == 0 ? 0.1 : 5);
      const double from = (level ? x : y) + (back ? 1 + away : -away);
      const double beside = border + 0.5 * draw.whole(-4, 4) * ulp;
      const Vec2 origin = level ? Vec2(from, beside) : Vec2(beside, from);
      const Vec2 way = level ? Vec2(back ? -1 : 1, rise) : Vec2(rise, back ? -1 : 1);
      const Vec2 scale(view.scale_x, view.scale_y);
      for (int copy = 0; copy < 16; ++copy)
        c.rays.add({origin.cwiseQuotient(scale) + Vec2(view.centre_x, view.centre_y),
                    way.cwiseQuotient(scale)});
    }
    std::vector<NearestHit> hits(c.rays.size());
    for (const Isa isa : available_isas()) {
      const auto grid = find_tracer("grid")->build(c.walls, isa);
      grid->nearest(c.rays, hits);
      for (std::size_t i = 0; i < hits.size(); ++i)
        ASSERT_EQ(hits[i].surface, grid->nearest_of_one(c.rays.ray(i - i % 16)).surface)
            << isa_name(isa) << ", scene " << scene << ", ray " << i;
    }
  }
}

}  // namespace
}  // namespace flatray
