// Goals S1 to S6 and S16: what rays meet first, by the exact tracers, the paper's method and Embree as far as it is
// built in, in million rays a second of one thread; then the memory and the time to build (S15).
//   trace_nearest [--cells RAYS,SCENE] [--most N]     e.g. --cells random,uniform --most 4096
#include <fmt/core.h>

#include <cstring>

#include "chamber.h"
#include "measure.h"
#include "plain_lanes.h"
#include "trace/tracer.h"
#include "trace_scenes.h"
#include "tracing.h"

namespace {

using bench::Chamber;
using bench::Flatray;
using flatray::RayBatch;

// The same, a call a ray (goal S3).
class OneByOne : public Flatray {
 public:
  using Flatray::Flatray;
  std::string name() const override { return Flatray::name() + ", 1"; }
  bool for_chambers() const override { return false; }
  std::string remark() const override { return {}; }
  void trace() override {
    for (std::size_t i = 0; i < hits_.size(); ++i) hits_[i] = walls_->nearest_of_one(rays_.ray(i));
  }
};

// Answers of all against the first's: what differs by more than float can tell, by ray.
std::size_t differing(bench::Tracing& a, bench::Tracing& b, const RayBatch& rays) {
  a.take(rays);
  b.take(rays);
  a.trace();
  b.trace();
  std::size_t differ = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const bench::Met x = a.met(i), y = b.met(i);
    const bool missed = (x.surface == flatray::kNoSurface) != (y.surface == flatray::kNoSurface);
    if (missed || std::fabs(x.t - y.t) > 1e-3 * (1 + std::fabs(x.t))) ++differ;
  }
  return differ;
}

struct Options {
  std::string cells;
  std::size_t most = 1 << 20;
  bool wants(const std::string& rays, const bench::Layout& layout) const {
    return cells.empty() || cells == rays + "," + layout.name;
  }
};

std::vector<std::unique_ptr<bench::Tracing>> contenders(const bench::Room& room,
                                                        std::size_t segments) {
  bench::Tracings all;
  for (const flatray::Tracer* tracer : flatray::tracers())
    if (std::strcmp(tracer->name, "grid") == 0 ||
        (room.walls.segments.size() <= 256 && std::strcmp(tracer->name, "brute") == 0) ||
        (segments <= 256 && std::strncmp(tracer->name, "cyrus-beck", 10) == 0))
      all.push_back(std::make_unique<Flatray>(*tracer, room.walls));
  all.push_back(std::make_unique<OneByOne>(*flatray::choose_tracer(room.walls).tracer, room.walls));
  if (room.walls.curve_numbers.empty()) bench::add_plain_lanes(room.walls, all);
#ifdef BENCH_EMBREE
  if (room.walls.beziers.empty()) bench::add_embree(room.walls, 0.5, all);
#endif
  return all;
}

void print_row(const std::string& rays, const bench::Layout& layout, std::size_t segments,
               const bench::Tracings& all, const std::vector<double>& mrays,
               const std::vector<double>& differ) {
  double best_peer = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i]->name().starts_with("Embree")) best_peer = std::max(best_peer, mrays[i]);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool own = all[i]->name().starts_with("flatray");
    fmt::print("| {:7} | {:12} | {:7} | {:25} | {:12} | {:8.3f} | {:>5} | {:7.1e} |\n", rays,
               layout.name, segments, all[i]->name(), all[i]->arithmetic(), mrays[i],
               own && best_peer > 0 ? fmt::format("{:.2f}", mrays[i] / best_peer) : "", differ[i]);
  }
  std::fflush(stdout);
}

void compare_rays(const std::string& name, const RayBatch& rays, const bench::Layout& layout,
                  std::size_t segments, bench::Tracings& all) {
  std::vector<bench::Contender> turns;
  std::vector<double> differ, mrays;
  for (const auto& one : all) {
    differ.push_back(static_cast<double>(differing(*all.front(), *one, rays)) /
                     static_cast<double>(rays.size()));
    turns.push_back({one->name(), [&] { one->trace(); }});
  }
  for (const double seconds : bench::compare(turns, 9, 0.01))
    mrays.push_back(1e-6 * static_cast<double>(rays.size()) / seconds);
  print_row(name, layout, segments, all, mrays, differ);
}

void compare_chambers(const bench::Room& room, const bench::Layout& layout, bench::Tracings& all) {
  std::vector<bench::Contender> turns;
  std::vector<Chamber> chambers;
  bench::Tracings able;
  for (auto& one : all)
    if (one->for_chambers()) able.push_back(std::move(one));
  for (const auto& one : able) chambers.emplace_back(*one, room);
  for (std::size_t i = 0; i < able.size(); ++i)
    turns.push_back({able[i]->name(), [&chambers, i] { chambers[i].run(); }});
  std::vector<double> mrays;
  for (const double seconds : bench::compare(turns, 7, 0.01))
    mrays.push_back(1e-6 * Chamber::kBlock * Chamber::kBounces / seconds);
  print_row("chamber", layout, room.walls.size(), able, mrays, std::vector<double>(able.size()));
}

void compare_scene(std::size_t segments, const bench::Layout& layout, const Options& options) {
  const bool plain = layout.name == bench::kUniform.name;
  const bench::Room room = bench::room(segments, layout);
  bench::Tracings all = contenders(room, segments);
  const std::size_t count = segments >= 65536 ? 65536 : 16384;
  const auto try_rays = [&](const std::string& name, const RayBatch& rays) {
    if (options.wants(name, layout)) compare_rays(name, rays, layout, segments, all);
  };
  try_rays("random", bench::random_rays(count, room.side, 3));
  if (plain) try_rays("fan", bench::fan(count, room.side));
  if (plain) try_rays("grid", bench::pixel_grid(count, room.side));
  for (const auto& one : all)
    if (!one->remark().empty()) fmt::print("{}: {}\n", one->name(), one->remark());
  if (layout.curved == 0 && options.wants("chamber", layout)) compare_chambers(room, layout, all);
}

Options read_options(int count, char** arguments) {
  Options options;
  for (int i = 1; i + 1 < count; i += 2) {
    if (std::string(arguments[i]) == "--cells") options.cells = arguments[i + 1];
    if (std::string(arguments[i]) == "--most") options.most = std::stoul(arguments[i + 1]);
  }
  return options;
}

}  // namespace

int main(int count, char** arguments) {
  const Options options = read_options(count, arguments);
  fmt::print(
      "\nS1 to S6, S16: million rays a second, medians of rounds in turn, CPU time of one "
      "thread;\n"
      "arithmetic: what decides whether a ray meets a wall; Embree has no formula of curves, "
      "which are\n"
      "its user geometry: found by its tree, and decided by ours in floats;\n"
      "ratio: to the best of Embree in that row; differ: share of rays whose t is not the first\n"
      "row's to 0.1 % (floats tie, and miss).\n"
      "| rays    | scene        |       N | who                       | arithmetic   |  Mrays/s | "
      "ratio "
      "| differ |\n"
      "|---|---|---|---|---|---|---|---|\n");
  for (const std::size_t segments : {16UL, 256UL, 4096UL, 65536UL, 1048576UL})
    if (segments <= options.most) compare_scene(segments, bench::kUniform, options);
  for (const bench::Layout& layout : {bench::kPower2, bench::kSparse, bench::kPower6})
    for (const std::size_t segments : {4096UL, 65536UL})
      if (segments <= options.most) compare_scene(segments, layout, options);
  for (const bench::Layout& layout : bench::kCurved) compare_scene(1000, layout, options);
}
