// How long does an OBJ mesh take from its bytes to its outline, and what do more threads save?
//   obj_parse [MESH.obj...]     without arguments: grids of 1000 to 1 000 000 triangles
// Rounds of all stages are interleaved; medians of CPU time of the process for one thread, of wall time beside it.
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <map>

#include "base/file.h"
#include "base/philox.h"
#include "scene/imports/obj_text.h"
#include "scene/outlines/outline.h"
#include "scene/reading/format.h"

namespace {

using namespace flatray;

// A square grid whose vertices are shaken, two triangles a cell, six decimals as most writers have.
std::string grid(std::size_t faces) {
  const auto columns = static_cast<std::size_t>(std::sqrt(static_cast<double>(faces) / 2));
  std::string text;
  const auto shaken = [](std::size_t whole, std::size_t item) {
    const std::uint64_t bits = random_bits(1, Stream::test, 0, item) % 600'000;
    return fmt::format("{}.{:06}", whole, bits);
  };
  const std::size_t rows = (faces + 2 * columns - 1) / (2 * columns), stride = columns + 1;
  for (std::size_t i = 0; i < (rows + 1) * stride; ++i)
    text += fmt::format("v {} {} {}\n", shaken(i % stride, 3 * i), shaken(i / stride, 3 * i + 1),
                        shaken(0, 3 * i + 2));
  for (std::size_t i = 0; i < faces; ++i) {
    const std::size_t a = i / 2 / columns * stride + i / 2 % columns + 1, d = a + stride + 1;
    text += i % 2 == 0 ? fmt::format("f {} {} {}\n", a, a + 1, d)
                       : fmt::format("f {} {} {}\n", a, d, d - 1);
  }
  return text;
}

struct Seconds {
  std::vector<double> cpu, wall;
};

double cpu_now() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Work>
auto timed(Seconds& seconds, const Work& work) {
  const double cpu = cpu_now();
  const auto wall = std::chrono::steady_clock::now();
  auto result = work();
  seconds.cpu.push_back(cpu_now() - cpu);
  seconds.wall.push_back(
      std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count());
  return result;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

bool same(const ObjText& a, const ObjText& b) {
  return a.vertices == b.vertices && a.faces.corners == b.faces.corners &&
         a.faces.begin == b.faces.begin && a.lines.corners == b.lines.corners;
}

void measure(const std::string& name, const std::string& text) {
  const std::size_t rounds = std::clamp<std::size_t>(60'000'000 / text.size(), 7, 201);
  Seconds lines, one, two, shape, outlined;
  std::size_t faces = 0, edges = 0;
  for (std::size_t round = 0; round < rounds; ++round) {
    std::string copy = text;
    const SourcePtr source = timed(
        lines, [&] { return std::make_shared<const SourceText>("mesh.obj", std::move(copy)); });
    const auto serial = timed(one, [&] { return parse_obj(source, 1); });
    const auto parallel = timed(two, [&] { return parse_obj(source, 2); });
    if (!serial || !parallel || !same(*serial, *parallel)) {
      fmt::print(stderr, "{}: refused, or different by threads\n", name);
      std::exit(1);
    }
    faces = serial->faces.size();
    Diagnostics warnings;
    const auto made = timed(
        shape, [&] { return find_format("obj")->outline(source, OutlineOptions{}, warnings); });
    edges = timed(outlined, [&] { return outline(*made); }).size();
  }
  const double mb = static_cast<double>(text.size()) / 1e6;
  fmt::print(
      "| {} | {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.0f} | {:.2f} | {:.2f} | {:.2f} | {} |\n",
      name, faces, mb, 1e3 * median(one.cpu), 1e3 * median(one.wall), 1e3 * median(two.wall),
      mb / median(one.cpu), 1e3 * median(lines.cpu), 1e3 * (median(shape.cpu) - median(one.cpu)),
      1e3 * median(outlined.cpu), edges);
}

}  // namespace

int main(int count, char** arguments) {
  fmt::print(
      "| mesh | faces | MB | parse, ms CPU | wall | 2 threads, wall | MB/s of CPU | find lines, ms "
      "| "
      "pieces, ms | outline, ms | edges left |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (int i = 1; i < count; ++i)
    if (const Result<std::string> text = read_file(arguments[i])) measure(arguments[i], *text);
  if (count > 1) return 0;
  for (const std::size_t faces : {1000u, 10'000u, 100'000u, 1'000'000u})
    measure(fmt::format("grid {}", faces), grid(faces));
}
