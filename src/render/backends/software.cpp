#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"
#include "image/tile.h"
#include "render/coverage_scan.h"
#include "render/frame.h"
#include "render/select_kernels.h"

namespace flatray {
namespace {

constexpr int kBandPixels = 1 << 15;    // half a megabyte of floats: stays in the second cache
constexpr std::size_t kBandsATask = 4;  // which share their room
constexpr std::size_t kFewEdges =
    48;  // looking at all of them costs less than sorting them by band

// What of an item lies in a band of rows: all edges, or those listed.
struct BandItem {
  std::size_t item;
  std::vector<std::uint32_t> edges;
};

using Premultiplied = std::array<float, 4>;

Premultiplied premultiplied(const LinearColour& c) {
  return {c.r * c.a, c.g * c.a, c.b * c.a, c.a};
}

Bounds region_bounds(const FillPath& path) {
  Bounds bounds;
  for (const Segment& edge : path.edges) bounds.add(edge.a), bounds.add(edge.b);
  return bounds;
}

Bounds region_bounds(const FillRing& ring) {
  const Vec2 reach(ring.radius + 1, ring.radius + 1);  // a pixel of margin for rounding
  return {ring.centre - reach, ring.centre + reach};
}

// Rows of the crop, cut into bands by its width alone, and what lies in each.
class Bands {
 public:
  Bands(const DrawList& list, const PixelBox& crop)
      : crop_(crop),
        rows_(std::clamp(kBandPixels / std::max(crop.width, 1), 1, 64)),
        items_(static_cast<std::size_t>((crop.height + rows_ - 1) / rows_)) {
    for (std::size_t i = 0; i < list.items.size(); ++i) add(i, list.items[i]);
  }

  std::size_t count() const { return items_.size(); }
  const std::vector<BandItem>& items(std::size_t band) const { return items_[band]; }
  PixelBox box(std::size_t band) const {
    const int top = static_cast<int>(band) * rows_;
    return {crop_.x, crop_.y + top, crop_.width, std::min(rows_, crop_.height - top)};
  }

 private:
  void add(std::size_t index, const DrawItem& item) {
    const Bounds bounds =
        std::visit([](const auto& region) { return region_bounds(region); }, item.region);
    if (item.colour.a == 0 || bounds.empty() || bounds.high.x() <= crop_.x ||
        bounds.low.x() >= crop_.x + crop_.width || bounds.high.y() <= crop_.y ||
        bounds.low.y() >= crop_.y + crop_.height)
      return;
    const std::size_t first = band_of(bounds.low.y()), last = band_of(bounds.high.y());
    for (std::size_t band = first; band <= last; ++band) items_[band].push_back({index, {}});
    const FillPath* path = std::get_if<FillPath>(&item.region);
    if (path != nullptr && path->edges.size() > kFewEdges) sort_edges(*path);
  }

  void sort_edges(const FillPath& path) {
    for (std::uint32_t i = 0; i < path.edges.size(); ++i) {
      const auto [low, high] = std::minmax(path.edges[i].a.y(), path.edges[i].b.y());
      if (high < crop_.y || low > crop_.y + crop_.height) continue;
      for (std::size_t band = band_of(low); band <= band_of(high); ++band)
        items_[band].back().edges.push_back(i);
    }
  }

  std::size_t band_of(double y) const {
    const double row = std::clamp<double>(std::floor(y) - crop_.y, 0, crop_.height - 1);
    return static_cast<std::size_t>(row) / static_cast<std::size_t>(rows_);
  }

  PixelBox crop_;
  int rows_;
  std::vector<std::vector<BandItem>> items_;
};

// Draws bands one after another; its room is kept from one to the next.
class BandPainter {
 public:
  explicit BandPainter(const DrawList& list)
      : list_(list),
        kernels_(span_kernels(active_isa())),
        area_scan_(kernels_),
        centre_scan_(kernels_) {}

  const Tile& paint(const PixelBox& box, const std::vector<BandItem>& items) {
    tile_.width = box.width;
    tile_.height = box.height;
    const std::size_t pixels =
        static_cast<std::size_t>(box.width) * static_cast<std::size_t>(box.height);
    tile_.rgba.resize(4 * pixels);
    kernels_.fill(tile_.rgba.data(), pixels, premultiplied(list_.background).data());
    for (const BandItem& item : items) draw(item, box);
    return tile_;
  }
  Tile& tile() { return tile_; }

 private:
  void draw(const BandItem& band_item, const PixelBox& box) {
    const DrawItem& item = list_.items[band_item.item];
    runs_.clear();
    if (const FillPath* path = std::get_if<FillPath>(&item.region)) {
      const auto* chosen = path->edges.size() > kFewEdges ? &band_item.edges : nullptr;
      if (list_.coverage == Coverage::area)
        area_scan_.scan(*path, chosen, box, runs_);
      else
        centre_scan_.scan(*path, chosen, box, runs_);
    } else {
      CoverageStats stats;
      scan_ring(std::get<FillRing>(item.region), list_.coverage, box, runs_, stats);
    }
    const std::vector<Run>& runs = runs_.runs();
    kernels_.blend_runs({tile_.rgba.data(), box.x, box.y, box.width}, runs.data(), runs.size(),
                        premultiplied(item.colour).data());
  }

  const DrawList& list_;
  const kernels::SpanKernels& kernels_;
  Tile tile_;
  AreaScan area_scan_;
  CentreScan centre_scan_;
  RunList runs_;
};

template <class Picture>
void render(const DrawList& list, const PixelBox& crop, unsigned threads, Picture& out) {
  const Bands bands(list, crop);
  const std::size_t tasks = (bands.count() + kBandsATask - 1) / kBandsATask;
  parallel_for(tasks, threads, [&](std::size_t task) {
    BandPainter painter(list);
    const std::size_t end = std::min(bands.count(), (task + 1) * kBandsATask);
    for (std::size_t band = task * kBandsATask; band < end; ++band) {
      const PixelBox box = bands.box(band);
      painter.tile().x = 0;
      painter.tile().y = box.y - crop.y;
      develop(painter.paint(box, bands.items(band)), out);
    }
  });
}

PixelBox crop_of(const DrawList& list, const FrameOptions& options) {
  return options.crop.value_or(PixelBox{0, 0, list.width, list.height});
}

}  // namespace

Image render_image(const DrawList& list, const FrameOptions& options) {
  const PixelBox crop = crop_of(list, options);
  Image image(crop.width, crop.height, list.background.a == 1 ? 3 : 4);
  render(list, crop, options.threads, image);
  return image;
}

LinearImage render_linear(const DrawList& list, const FrameOptions& options) {
  const PixelBox crop = crop_of(list, options);
  LinearImage image{crop.width, crop.height, {}};
  image.pixels.resize(3 * static_cast<std::size_t>(crop.width) *
                      static_cast<std::size_t>(crop.height));
  render(list, crop, options.threads, image);
  return image;
}

}  // namespace flatray
