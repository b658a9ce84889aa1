// Walls and rays on whole numbers, whose sides are exact in doubles: what rays that no lanes are sure of cost, beside
// the same scene with one wall off the grid, far away. CPU nanoseconds a ray; the share that leaves the lanes.
#include <fmt/core.h>

#include "measure.h"
#include "oracle/families.h"
#include "trace/tracer.h"
#include "trace_scenes.h"

namespace {

using flatray::RayBatch;
using flatray::Surfaces;
using flatray::Vec2;

struct Case {
  std::string name;
  Surfaces whole, other;
  RayBatch rays;
};

// A wall that no ray meets, off the grid of whole numbers.
Surfaces with_one_off(Surfaces walls) {
  walls.add(flatray::Segment{{1.0 / 3, 1.0 / 3}, {1.0 / 3, 1.0 / 3 + 0x1p-30}});
  return walls;
}
Case made(std::string name, Surfaces walls, RayBatch rays) {
  return {std::move(name), walls, with_one_off(walls), std::move(rays)};
}

struct Family {
  std::string name;
  std::vector<Case> scenes;
};

Family family(const flatray::oracle::Family& of) {
  Family all{of.name, {}};
  for (std::uint64_t item = 0; item < 64; ++item) {
    const auto scene = flatray::oracle::make_scene(of, 1, item);
    RayBatch rays;
    for (const flatray::Ray& ray : scene.rays) rays.add(ray);
    all.scenes.push_back(made(of.name, scene.surfaces(), std::move(rays)));
  }
  return all;
}

double whole(double x, double scale) { return std::nearbyint(x * scale); }
Vec2 whole(const Vec2& v, double scale) { return {whole(v.x(), scale), whole(v.y(), scale)}; }

// The uniform room of benchmarks/trace_nearest on whole numbers.
Family uniform(std::size_t count, double cell, bool at_vertices) {
  const bench::Room room = bench::room(count, bench::kUniform);
  Surfaces walls;
  for (const auto& s : room.walls.segments)
    walls.add(flatray::Segment{whole(s.a, cell), whole(s.b, cell)});
  const RayBatch any = bench::random_rays(4096, room.side, 5);
  RayBatch rays;
  for (std::size_t i = 0; i < any.size(); ++i) {
    const Vec2 origin = whole(any.ray(i).origin, cell);
    const Vec2 to = walls.segments[i * 7 % walls.size()].a - origin;
    rays.add({origin, at_vertices ? to : whole(any.ray(i).direction, cell)});
  }
  Family one{fmt::format("uniform {} x {}{}", count, cell, at_vertices ? " vertices" : ""), {}};
  one.scenes.push_back(made(one.name, std::move(walls), std::move(rays)));
  return one;
}

void measure(const Family& family, const char* tracer) {
  std::vector<std::unique_ptr<flatray::Accelerator>> with, without;
  std::size_t rays = 0, left = 0, whole = 0;
  std::vector<flatray::NearestHit> hits(4096), others(4096);
  for (const Case& c : family.scenes) {
    with.push_back(flatray::find_tracer(tracer)->build(c.whole));
    without.push_back(flatray::find_tracer(tracer)->build(c.other));
    rays += c.rays.size();
    const flatray::LeftByLanes of_case = with.back()->left_by_lanes(c.rays);
    left += of_case.rays;
    whole += of_case.whole;
  }
  const auto all = [&](const auto& walls) {
    for (std::size_t i = 0; i < family.scenes.size(); ++i)
      walls[i]->nearest(family.scenes[i].rays, hits);
  };
  const auto seconds =
      bench::compare({{"", [&] { all(with); }}, {"", [&] { all(without); }}}, 9, 0.02);
  const auto n = static_cast<double>(rays);
  fmt::print("{:<26} {:<6} {:>8.1f} {:>8.1f} {:>6.2f} {:>8.2f} % {:>8.2f} %\n", family.name, tracer,
             1e9 * seconds[0] / n, 1e9 * seconds[1] / n, seconds[1] / seconds[0],
             100 * static_cast<double>(left) / n, 100 * static_cast<double>(whole) / n);
}

}  // namespace

int main() {
  std::vector<Family> all;
  for (const auto& each : flatray::oracle::families())
    for (const char* name : {"grid", "vertex", "edge", "degenerate", "random"})
      if (std::string_view(each.name) == name) all.push_back(family(each));
  for (const std::size_t count : {16UL, 256UL, 4096UL}) {
    all.push_back(uniform(count, 0x1p12, false));
    all.push_back(uniform(count, 0x1p4, false));
    all.push_back(uniform(count, 0x1p12, true));
  }
  fmt::print("{:<26} {:<6} {:>8} {:>8} {:>6} {:>10} {:>10}\n", "rays", "tracer", "whole", "other",
             "ratio", "left", "whole");
  for (const Family& each : all)
    for (const char* tracer : {"grid", "brute"}) {
      if (each.scenes.front().whole.size() > 300 && std::string_view(tracer) == "brute") continue;
      measure(each, tracer);
    }
}
