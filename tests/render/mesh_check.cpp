// Renders a mesh and holds its picture against a reference of 256 x 256 samples a pixel that shares
// nothing with the renderer's coverage: every sample row of a pixel is the union of the intervals
// its triangles cover.
//
//   mesh_check MESH.obj [WIDTH HEIGHT]
//
// Passes (exit 0) when no pixel inside differs from the fill and every pixel's coverage is within
// 1/256.
#include <fmt/core.h>

#include <bitset>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "anim/timeline.h"
#include "render/film_transform.h"
#include "render/frame.h"
#include "render/scan_region.h"
#include "scene/load.h"

namespace flatray {
namespace {

constexpr int kSamples = 256;
constexpr double kAllowed = 1.0 / 256;

struct Triangle {
  Vec2 corner[3];
};

// Pieces of the scene's only shape, in film pixels, cut into triangles from their first corner.
std::vector<Triangle> film_triangles(const Scene& scene, const FrameState& state) {
  const FilmTransform film_from_world(scene.film, state);
  const Shape& shape = scene.shapes[scene.entities[0].shape];
  const Pose place = pose(state.entities[0].at, state.entities[0].angle);
  std::vector<Triangle> triangles;
  for (std::size_t piece = 0; piece < shape.piece_count(); ++piece)
    for (std::size_t i = shape.begin[piece] + 1; i + 1 < shape.begin[piece + 1]; ++i)
      triangles.push_back({{film_from_world(place(shape.vertices[shape.begin[piece]])),
                            film_from_world(place(shape.vertices[i])),
                            film_from_world(place(shape.vertices[i + 1]))}});
  return triangles;
}

using Buckets = std::vector<std::vector<std::uint32_t>>;

Buckets by_pixel(const std::vector<Triangle>& triangles, int width, int height) {
  Buckets buckets(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    Bounds box;
    for (const Vec2& corner : triangles[t].corner) box.add(corner);
    const int x0 = std::max(0, static_cast<int>(std::floor(box.low.x())));
    const int y0 = std::max(0, static_cast<int>(std::floor(box.low.y())));
    const int x1 = std::min(width - 1, static_cast<int>(std::floor(box.high.x())));
    const int y1 = std::min(height - 1, static_cast<int>(std::floor(box.high.y())));
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x)
        buckets[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(x)]
            .push_back(t);
  }
  return buckets;
}

using SampleRow = std::bitset<kSamples>;

// Samples of one row of a pixel that a triangle covers: centres between its two edges at that
// height.
void cover(const Triangle& triangle, double x, double y, SampleRow& row) {
  double low = kInfinity, high = -kInfinity;
  for (int i = 0; i < 3; ++i) {
    const Vec2& a = triangle.corner[i];
    const Vec2& b = triangle.corner[(i + 1) % 3];
    if ((a.y() <= y) == (b.y() <= y)) continue;
    const double at = a.x() + (y - a.y()) * (b.x() - a.x()) / (b.y() - a.y());
    low = std::min(low, at);
    high = std::max(high, at);
  }
  if (!(low < high)) return;
  const double first = std::ceil((low - x) * kSamples - 0.5);
  const double last = std::ceil((high - x) * kSamples - 0.5);
  const int begin = static_cast<int>(std::clamp(first, 0.0, double{kSamples}));
  const int end = static_cast<int>(std::clamp(last, 0.0, double{kSamples}));
  if (begin < end)
    row |= (SampleRow().set() >> (kSamples - static_cast<std::size_t>(end - begin)))
           << static_cast<std::size_t>(begin);
}

double reference(const std::vector<Triangle>& triangles, const std::vector<std::uint32_t>& bucket,
                 int x, int y) {
  std::size_t covered = 0;
  for (int j = 0; j < kSamples; ++j) {
    SampleRow row;
    for (const std::uint32_t t : bucket) cover(triangles[t], x, y + (j + 0.5) / kSamples, row);
    covered += row.count();
  }
  return static_cast<double>(covered) / (double{kSamples} * kSamples);
}

struct Totals {
  std::uint64_t interior = 0, interior_wrong = 0, edge = 0;
  double worst = 0, sum = 0;

  void add(double expected, double actual, bool shows_fill) {
    if (expected == 1.0) {
      ++interior;
      interior_wrong += shows_fill ? 0 : 1;
    }
    if (expected == 0.0 && actual == 0.0) return;
    if (expected == 1.0 && actual == 1.0) return;
    ++edge;
    worst = std::max(worst, std::abs(expected - actual));
    sum += std::abs(expected - actual);
  }
};

int check(const std::string& path, const std::string& size) {
  const Result<LoadedScene> loaded = load_scene(path, {{"film.size", size}});
  if (!loaded) {
    std::fputs(format(loaded.error()).c_str(), stderr);
    return 4;
  }
  const Scene& scene = loaded->scene;
  const int width = scene.film.width, height = scene.film.height;
  const Timeline timeline(scene, scene.seed, 1);
  const DrawList list = *draw_list(make_plan(scene, false), timeline, 1);
  const Image image = render_image(list, {});

  const Steps steps = steps_of(list.items.at(0).region, {0, 0, width, height});

  const std::vector<Triangle> triangles = film_triangles(scene, at(timeline, 1));
  const Buckets buckets = by_pixel(triangles, width, height);
  const Colour fill = *scene.entities[0].fill;
  Totals totals;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                            static_cast<std::size_t>(x);
      const double expected = buckets[i].empty() ? 0.0 : reference(triangles, buckets[i], x, y);
      const std::uint8_t* pixel = image.at(x, y);
      totals.add(expected, steps[i] / double{kFullCoverage},
                 pixel[0] == fill.r && pixel[1] == fill.g && pixel[2] == fill.b);
    }
  std::printf(
      "%s at %dx%d: %zu triangles, %llu interior pixels (%llu differ from the fill), %llu edge "
      "pixels, coverage off by %.6f at most (allowed %.6f), %.7f on average\n",
      path.c_str(), width, height, triangles.size(),
      static_cast<unsigned long long>(totals.interior),
      static_cast<unsigned long long>(totals.interior_wrong),
      static_cast<unsigned long long>(totals.edge), totals.worst, kAllowed,
      totals.edge == 0 ? 0.0 : totals.sum / static_cast<double>(totals.edge));
  return totals.interior_wrong == 0 && totals.worst <= kAllowed && totals.interior > 0 ? 0 : 1;
}

}  // namespace
}  // namespace flatray

int main(int argc, char** argv) {
  if (argc != 2 && argc != 4) {
    std::fputs("usage: mesh_check MESH.obj [WIDTH HEIGHT]\n", stderr);
    return 2;
  }
  const std::string size =
      argc == 4 ? fmt::format("[{}, {}]", argv[2], argv[3]) : std::string("[1920, 1080]");
  return flatray::check(argv[1], size);
}
