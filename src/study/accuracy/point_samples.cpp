#include "study/accuracy/point_samples.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "image/pixel_runs.h"
#include "render/coverage/band_scan.h"
#include "render/frame.h"

namespace flatray {
namespace {

constexpr double kNear = 0x1p-7;
constexpr int kLevels = 1;  // that rounding may move a colour by

void move(FillPath& path, const Vec2& shift) {
  for (Segment& edge : path.edges) edge.a += shift, edge.b += shift;
}
void move(FillRing& ring, const Vec2& shift) { ring.centre += shift; }
void move(FillArcs& region, const Vec2& shift) {
  for (EllipseArc& arc : region.path.arcs) arc.centre += shift;
}

// What the pixel centres of the result see is what `place` sees in each pixel of `list`. Gradients
// stay: samples have the colour of their pixel's centre.
DrawList seen_from(const DrawList& list, const SamplePlace& place) {
  const Vec2 shift(0.5 - place[0], 0.5 - place[1]);
  DrawList moved = list;
  moved.coverage = Coverage::centre;
  for (DrawItem& item : moved.items)
    std::visit([&](auto& region) { move(region, shift); }, item.region);
  return moved;
}

// Light and alpha of a list, 4 floats a pixel, premultiplied.
std::vector<float> light_of(DrawList list, unsigned threads) {
  const LinearImage colour = render_linear(list, {std::nullopt, threads});
  const auto whiten = [](LinearColour& c) { c.r = c.g = c.b = 1; };
  whiten(list.background);
  for (DrawItem& item : list.items) {
    whiten(item.colour);
    if (item.gradient)
      for (FilmGradient::Stop& stop : item.gradient->stops) whiten(stop.colour);
  }
  const LinearImage alpha = render_linear(list, {std::nullopt, threads});  // white light is alpha
  std::vector<float> rgba;
  for (std::size_t i = 0; i < colour.pixels.size(); i += 3)
    rgba.insert(rgba.end(),
                {colour.pixels[i], colour.pixels[i + 1], colour.pixels[i + 2], alpha.pixels[i]});
  return rgba;
}

// Of `count` samples in a row or column, each at `place` in its pixel, the first and last that are
// from `low` to `high`, or within kNear.
std::pair<int, int> samples_from(double low, double high, double place, int count) {
  return {static_cast<int>(std::clamp(std::ceil(low - kNear - place), 0.0, 1.0 * count)),
          static_cast<int>(std::clamp(std::floor(high + kNear - place), -1.0, count - 1.0))};
}

// Samples within kNear of a straight edge, row by row: of a sliver no place beside may tell.
void mark_beside(const Segment& edge, const DrawList& list, const SamplePlace& place,
                 std::vector<bool>& near) {
  const auto [top, bottom] = std::minmax(edge.a.y(), edge.b.y());
  const auto x_at = [&](double y) {
    const double height = edge.b.y() - edge.a.y();
    return height == 0 ? edge.a.x()
                       : edge.a.x() + (y - edge.a.y()) / height * (edge.b - edge.a).x();
  };
  const auto [first, last] = samples_from(top, bottom, place[1], list.height);
  for (int row = first; row <= last; ++row) {
    const double y = row + place[1];
    double left = x_at(std::clamp(y - kNear, top, bottom));
    double right = x_at(std::clamp(y + kNear, top, bottom));
    if (top == bottom) right = edge.b.x();
    if (left > right) std::swap(left, right);
    const auto [begin, end] = samples_from(left, right, place[0], list.width);
    for (int x = begin; x <= end; ++x)
      near[static_cast<std::size_t>(row) * static_cast<std::size_t>(list.width) +
           static_cast<std::size_t>(x)] = true;
  }
}

void mark_beside(const DrawList& list, const SamplePlace& place, std::vector<bool>& near) {
  for (const DrawItem& item : list.items)
    if (const auto* path = std::get_if<FillPath>(&item.region))
      for (const Segment& edge : path->edges) mark_beside(edge, list, place, near);
}

int largest_gap(const std::uint8_t* a, const std::uint8_t* b, int channels) {
  int gap = 0;
  for (int c = 0; c < channels; ++c) gap = std::max(gap, std::abs(a[c] - b[c]));
  return gap;
}

}  // namespace

std::vector<SamplePlace> sample_places(Coverage coverage, unsigned count) {
  if (coverage == Coverage::centre) return {{0.5, 0.5}};
  constexpr SamplePlace kFour[] = {{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}};
  const unsigned times = count / 4, root = times == 16 ? 4 : times == 4 ? 2 : 1;
  std::vector<SamplePlace> places;
  for (unsigned i = 0; i < times; ++i) {
    const auto moved = [times](unsigned k) { return (k - 0.5 * (times - 1)) / (4.0 * times); };
    for (const SamplePlace& place : kFour)  // a picture moved right is seen farther left
      places.push_back({place[0] - moved(i), place[1] - moved(i % root * root + i / root)});
  }
  return places;
}

LinearImage mean_light(const DrawList& list, std::span<const SamplePlace> places,
                       unsigned threads) {
  std::vector<double> sum;
  LinearImage mean;
  for (const SamplePlace& place : places) {
    mean = render_linear(seen_from(list, place), {std::nullopt, threads});
    sum.resize(mean.pixels.size());
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += static_cast<double>(mean.pixels[i]);
  }
  for (std::size_t i = 0; i < sum.size(); ++i)
    mean.pixels[i] = static_cast<float>(sum[i] / static_cast<double>(places.size()));
  return mean;
}

PointSampled point_sampled(const DrawList& list, std::span<const SamplePlace> places,
                           unsigned threads) {
  const auto pixels = static_cast<std::size_t>(list.width) * static_cast<std::size_t>(list.height);
  PointSampled out{Image(list.width, list.height, list.background.a == 1 ? 3 : 4),
                   std::vector<bool>(pixels)};
  std::vector<double> sum(4 * pixels);
  for (const SamplePlace& place : places) {
    const std::vector<float> seen = light_of(seen_from(list, place), threads);
    for (std::size_t i = 0; i < seen.size(); ++i) sum[i] += static_cast<double>(seen[i]);
    mark_beside(list, place, out.near);
    for (const double dx : {-kNear, kNear})
      for (const double dy : {-kNear, kNear}) {
        const auto beside = light_of(seen_from(list, {place[0] + dx, place[1] + dy}), threads);
        for (std::size_t i = 0; i < seen.size(); ++i)
          if (beside[i] != seen[i]) out.near[i / 4] = true;
      }
  }
  std::vector<Light> colours(pixels);
  for (std::size_t i = 0; i < sum.size(); ++i)
    colours[i / 4][i % 4] = static_cast<float>(sum[i] / static_cast<double>(places.size()));
  put_rows(colours, list.width, 0, 0, out.picture);
  return out;
}

namespace {

// Marks the pixels that a scan finds an edge in.
class EdgeSink final : public PixelSink {
 public:
  EdgeSink(std::vector<bool>& edges, int width) : edges_(edges), width_(width) {}
  void run(int, int, int, const Light&) override {}
  void pixel(int y, int x, const Light&) override {
    edges_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x)] = true;
  }

 private:
  std::vector<bool>& edges_;
  int width_;
};

}  // namespace

std::vector<bool> edge_pixels(const DrawList& list) {
  std::vector<bool> edges(static_cast<std::size_t>(list.width) *
                          static_cast<std::size_t>(list.height));
  DrawList plain = list;
  plain.coverage = Coverage::area;
  for (DrawItem& item : plain.items)
    item.gradient.reset(), item.light = nullptr, item.colour.a = 0.5F;
  const Bands bands(plain, {0, 0, list.width, list.height});
  BandScan scan(plain, false, nullptr);
  EdgeSink sink(edges, list.width);
  Band items;
  for (std::size_t band = 0; band < bands.count(); ++band) {
    bands.list(band, items);
    scan.scan(bands.box(band), items, sink);
  }
  return edges;
}

DifferenceCauses difference_causes(const Image& drawn, const Image& exact,
                                   const PointSampled& sampled, const std::vector<bool>& edges) {
  DifferenceCauses all;
  for (int y = 0; y < drawn.height; ++y)
    for (int x = 0; x < drawn.width; ++x) {
      const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(drawn.width) +
                     static_cast<std::size_t>(x);
      const auto gap = [&](const Image& other) {
        return largest_gap(drawn.at(x, y), other.at(x, y), drawn.channels);
      };
      if (edges[i])
        ++all.edge;
      else
        all.flat_worst = std::max(all.flat_worst, gap(exact));
      if (gap(sampled.picture) <= kLevels)
        all.sampled += edges[i] ? 1 : 0;
      else if (sampled.near[i])
        ++all.rounded;
      else
        ++all.unexplained;
    }
  return all;
}

}  // namespace flatray
