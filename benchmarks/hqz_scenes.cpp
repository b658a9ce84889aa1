// Goal S8: the six scenes of HQZ, from file to PNG, beside a short tracer of the same walls by brute force in the same run, and
// beside what HQZ itself took on another machine. hqz_scenes [FOLDER [ROUNDS]]
#include <fmt/core.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "oracle/flat_light.h"
#include "process.h"
#include "scene/imports/hqz_scene.h"
#include "scene/reading/json_value.h"
#include "transport/light/forward.h"

namespace {

namespace fs = std::filesystem;
using namespace flatray;

// Seconds of CPU time that HQZ took for `rays`, one thread, measured once on another machine of the same
// kind: no program of HQZ is run here.
struct Noted {
  const char* name;
  std::uint64_t rays;
  double seconds;
};
constexpr Noted kNoted[] = {{"quick", 100'000, 0.087},      {"colors", 200'000, 0.309},
                            {"duel-5000k", 400'000, 1.860}, {"laser-rainbow", 200'000, 2.121},
                            {"spotlight", 200'000, 3.323},  {"stormy", 200'000, 2.251}};
int rounds = 3;

oracle::EvenRange even(const HqzRange& range) { return {range.low, range.high}; }

oracle::FlatScene flat(const HqzScene& scene) {
  oracle::FlatScene made;
  for (const HqzLight& light : scene.lights)
    made.lamps.push_back({light.power.middle(),
                          {1, 1, 1},
                          even(light.x),
                          even(light.y),
                          even(light.polar_angle),
                          even(light.polar_distance),
                          even(light.ray_angle)});
  for (const HqzObject& object : scene.objects) {
    const HqzMaterial& material = scene.materials[object.material];
    made.walls.push_back({even(object.x), even(object.y), even(object.dx), even(object.dy),
                          material.scattered, material.through, material.mirrored});
  }
  made.left = scene.left, made.top = scene.top;
  made.width = scene.width, made.height = scene.height;
  return made;
}

// The best of some runs of a process, and the rays a second of it.
bench::ProcessCost render(const fs::path& flatray, const fs::path& scene, const fs::path& png,
                          std::uint64_t rays, const char* threads) {
  bench::ProcessCost best;
  for (int round = 0; round < std::max(rounds, 1); ++round) {
    const bench::ProcessCost cost =
        bench::run_process({flatray.string(), "render", scene.string(), "-o", png.string(), "-j",
                            threads, "--force", "-D", fmt::format("light.rays={}", rays)});
    if (!cost.worked) return cost;
    if (!best.worked || cost.wall < best.wall) best.wall = cost.wall;
    if (!best.worked || cost.cpu < best.cpu) best.cpu = cost.cpu;
    best.peak_mb = std::max(best.peak_mb, cost.peak_mb);
    best.worked = true;
  }
  return best;
}

std::optional<HqzScene> read(const fs::path& path) {
  std::ifstream file(path);
  if (!file) return std::nullopt;
  const auto source = std::make_shared<const SourceText>(
      path.string(), std::string(std::istreambuf_iterator<char>(file), {}));
  const Result<Value> value = json_value(source, 0, source->text().size());
  if (!value) return std::nullopt;
  Diagnostics warnings;
  Result<HqzScene> scene = read_hqz_scene(*value, {}, warnings);
  return scene ? std::optional(std::move(*scene)) : std::nullopt;
}

}  // namespace

int main(int count, char** arguments) {
  const fs::path flatray = fs::path(arguments[0]).parent_path().parent_path() / "flatray";
  const fs::path folder = count > 1 ? arguments[1] : BENCH_HQZ_SCENES;
  const fs::path png = fs::temp_directory_path() / fmt::format("hqz_scenes.{}.png", getpid());
  if (count > 2) rounds = std::atoi(arguments[2]);
  fmt::print(
      "Rays of the file: seconds of CPU time with one thread, of the clock with two, MB; thousands "
      "of "
      "rays a second of\nCPU time, with one thread and two (of the clock), of the short tracer (no "
      "PNG), and "
      "of HQZ as noted elsewhere.\nx HQZ: at the rays and seconds noted of it, CPU time with one "
      "thread, "
      "the clock with two.\n"
      "| scene | rays | s | s, two | MB | k/s | k/s, two | short k/s | x short | HQZ k/s, noted | "
      "x "
      "HQZ | x HQZ, two |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  double log_short = 0, log_one = 0, log_two = 0;
  int scenes = 0;
  for (const Noted& noted : kNoted) {
    const fs::path path = folder / (std::string(noted.name) + ".json");
    const std::optional<HqzScene> scene = read(path);
    if (!scene) {
      fmt::print("{} is absent\n", path.string());
      continue;
    }
    const auto rays = static_cast<std::uint64_t>(std::stod(std::string(source_text(*scene->rays))));
    const bench::ProcessCost one = render(flatray, path, png, rays, "1"),
                             two = render(flatray, path, png, rays, "2"),
                             few = render(flatray, path, png, noted.rays, "1"),
                             few_two = render(flatray, path, png, noted.rays, "2");
    if (!one.worked || !two.worked || !few.worked || !few_two.worked) return 1;
    constexpr std::uint64_t kShortRays = 20'000;
    const oracle::FlatScene walls = flat(*scene);
    const double start = bench::seconds(CLOCK_THREAD_CPUTIME_ID);
    (void)oracle::trace_flat(walls, static_cast<int>(scene->resolution[0]),
                             static_cast<int>(scene->resolution[1]), kShortRays, 1);
    const double brute = 1e-3 * kShortRays / (bench::seconds(CLOCK_THREAD_CPUTIME_ID) - start);
    const double traced = 1e-3 * static_cast<double>(rays_traced(rays));
    // Of the rays that are traced in full: a number between blocks is rounded up.
    const double part =
        static_cast<double>(noted.rays) / static_cast<double>(rays_traced(noted.rays));
    const double x_one = noted.seconds / (few.cpu * part),
                 x_two = noted.seconds / (few_two.wall * part);
    fmt::print(
        "| {} | {} | {:.2f} | {:.2f} | {:.0f} | {:.0f} | {:.0f} | {:.0f} | {:.1f} | {:.0f} | "
        "{:.1f} | {:.1f} |\n",
        noted.name, rays, one.cpu, two.wall, one.peak_mb, traced / one.cpu, traced / two.wall,
        brute, traced / one.cpu / brute, 1e-3 * static_cast<double>(noted.rays) / noted.seconds,
        x_one, x_two);
    log_short += std::log(traced / one.cpu / brute);
    log_one += std::log(x_one), log_two += std::log(x_two);
    ++scenes;
  }
  std::error_code none;
  fs::remove(png, none);
  fs::remove(png.string() + ".json", none);
  if (scenes > 0)
    fmt::print("geometric means: x short {:.1f}; x HQZ as noted: one thread {:.1f}, two {:.1f}\n",
               std::exp(log_short / scenes), std::exp(log_one / scenes),
               std::exp(log_two / scenes));
}
