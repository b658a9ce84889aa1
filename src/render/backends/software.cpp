#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"
#include "image/tile.h"
#include "render/backend.h"
#include "render/bands.h"
#include "render/flat_painter.h"
#include "render/gradient.h"
#include "render/item_scan.h"
#include "render/layer.h"
#include "render/select_kernels.h"

namespace flatray {
namespace {

constexpr std::size_t kBandsATask = 4;  // which share their room; one thread does all in one

// Draws bands one after another; its room is kept from one to the next.
class BandPainter {
 public:
  BandPainter(const DrawList& list, bool hide, DrawCounts& counts)
      : list_(list),
        hide_(hide),
        counts_(counts),
        kernels_(span_kernels(active_isa())),
        item_scan_(list) {}

  const Tile& paint(const PixelBox& box, const Band& band) {
    tile_.width = box.width;
    tile_.height = box.height;
    const std::size_t pixels =
        static_cast<std::size_t>(box.width) * static_cast<std::size_t>(box.height);
    tile_.rgba.resize(4 * pixels);
    ++counts_.bands;
    counts_.items += band.items.size();
    if (!scan(box, band)) kernels_.fill(tile_.rgba.data(), pixels, background().data());
    blend_all({tile_.rgba.data(), box.x, box.y, box.width}, box.height);
    return tile_;
  }
  Tile& tile() { return tile_; }

 private:
  struct Scanned {
    const DrawItem* item;
    std::size_t begin, end;  ///< of its runs
  };

  // From the uppermost item down, to the one that hides all below it; whether there is one.
  bool scan(const PixelBox& box, const Band& band) {
    runs_.clear();
    scanned_.clear();
    for (std::size_t i = band.items.size(); i-- > 0;) {
      const DrawItem& item = list_.items[band.items[i].item];
      const std::size_t begin = runs_.start();
      item_scan_.scan(band, band.items[i], box, runs_);
      scanned_.push_back({&item, begin, runs_.runs().size()});
      if (!hide_ || item.colour.a != 1 || item.opacity != 1 ||
          !covers_all(runs_.runs().subspan(begin), box))
        continue;
      counts_.hidden_items += i;
      return true;
    }
    return false;
  }

  void blend_all(const kernels::Target& target, int rows) {
    for (auto it = scanned_.rbegin(); it != scanned_.rend();) {
      const std::uint32_t layer = it->item->layer;
      if (layer == 0) {
        blend(*it++, target);
        continue;
      }
      const auto end = std::find_if(it, scanned_.rend(),
                                    [&](const Scanned& next) { return next.item->layer != layer; });
      const std::size_t begin = (end - 1)->begin;
      const PixelBox part = box_around(runs_.runs().subspan(begin, it->end - begin));
      layer_.clear(target, part, rows);
      const float opacity = it->item->opacity;
      for (; it != end; ++it) blend(*it, layer_.target());
      layer_.lay_over(target, part, opacity);
    }
  }

  void blend(const Scanned& scanned, const kernels::Target& target) {
    const std::span<const Run> runs =
        runs_.runs().subspan(scanned.begin, scanned.end - scanned.begin);
    if (scanned.item->gradient)
      GradientPainter(*scanned.item->gradient).blend_runs(target, runs);
    else
      kernels_.blend_runs(target, runs.data(), runs.size(),
                          premultiplied(scanned.item->colour).data());
  }

  std::array<float, 4> background() const { return premultiplied(list_.background); }

  const DrawList& list_;
  const bool hide_;
  DrawCounts& counts_;
  const kernels::SpanKernels& kernels_;
  Tile tile_;
  ItemScan item_scan_;
  RunList runs_;
  std::vector<Scanned> scanned_;
  Layer layer_;
};

void shape_picture(const PixelBox& crop, const DrawList& list, Image& image) {
  const int channels = list.background.a == 1 ? 3 : 4;
  if (image.width != crop.width || image.height != crop.height || image.channels != channels)
    image = Image(crop.width, crop.height, channels);
}
void shape_picture(const PixelBox& crop, const DrawList&, LinearImage& image) {
  image.width = crop.width;
  image.height = crop.height;
  image.pixels.resize(3 * static_cast<std::size_t>(crop.width) *
                      static_cast<std::size_t>(crop.height));
}

// The two ways to draw give the same pixels. Light, all that shall be drawn even if hidden, and
// bands with gradients or layers go by blending every item in order.
class BandsOfTask {
 public:
  BandsOfTask(const DrawList& list, const FrameOptions& options, DrawCounts& counts)
      : flat_(list, counts), blended_(list, !options.keep_all, counts), plain_(!options.keep_all) {}

  void draw(const PixelBox& box, const Band& band, int y, Image& out) {
    if (!plain_ || !band.flat || !flat_.paint(box, band, y, out)) draw_blended(box, band, y, out);
  }
  void draw(const PixelBox& box, const Band& band, int y, LinearImage& out) {
    draw_blended(box, band, y, out);
  }

 private:
  template <class Picture>
  void draw_blended(const PixelBox& box, const Band& band, int y, Picture& out) {
    blended_.tile().x = 0;
    blended_.tile().y = y;
    develop(blended_.paint(box, band), out);
  }

  FlatPainter flat_;
  BandPainter blended_;
  const bool plain_;
};

template <class Picture>
DrawCounts draw_bands(const DrawList& list, const Bands& bands, const std::vector<bool>& keep,
                      const FrameOptions& options, Picture& out) {
  const std::size_t each =
      options.threads == 1 ? std::max<std::size_t>(bands.count(), 1) : kBandsATask;
  const std::size_t tasks = (bands.count() + each - 1) / each;
  std::vector<DrawCounts> counts(tasks);
  const int top = crop_of(list, options).y;
  parallel_for(tasks, options.threads, [&](std::size_t task) {
    BandsOfTask painter(list, options, counts[task]);
    const std::size_t end = std::min(bands.count(), (task + 1) * each);
    for (std::size_t band = task * each; band < end; ++band) {
      if (options.stop != nullptr && options.stop()) {
        counts[task].stopped_bands += end - band;
        return;
      }
      if (keep[band]) {
        ++counts[task].kept_bands;
        continue;
      }
      const PixelBox box = bands.box(band);
      painter.draw(box, bands[band], box.y - top, out);
    }
  });
  DrawCounts sum;
  for (const DrawCounts& one : counts) sum += one;
  return sum;
}

}  // namespace

template <class Picture>
const Picture& FrameDrawer<Picture>::draw(DrawList list) {
  const PixelBox crop = crop_of(list, options_);
  Bands bands(list, crop);
  std::vector<bool> keep(bands.count());
  if (drawn_ && !options_.keep_all) keep = unchanged_bands(list, bands, list_, bands_);
  list_ = std::move(list);
  bands_ = std::move(bands);
  shape_picture(crop, list_, picture_);
  counts_ += draw_bands(list_, bands_, keep, options_, picture_);
  changed_ = !drawn_ || std::find(keep.begin(), keep.end(), false) != keep.end();
  drawn_ = true;
  return picture_;
}

template class FrameDrawer<Image>;
template class FrameDrawer<LinearImage>;

template <class Picture>
void render_into(const DrawList& list, const FrameOptions& options, Picture& picture) {
  const PixelBox crop = crop_of(list, options);
  const Bands bands(list, crop);
  shape_picture(crop, list, picture);
  draw_bands(list, bands, std::vector<bool>(bands.count()), options, picture);
}
template void render_into(const DrawList&, const FrameOptions&, Image&);
template void render_into(const DrawList&, const FrameOptions&, LinearImage&);

Image render_image(const DrawList& list, const FrameOptions& options) {
  Image image;
  render_into(list, options, image);
  return image;
}

LinearImage render_linear(const DrawList& list, const FrameOptions& options) {
  LinearImage image;
  render_into(list, options, image);
  return image;
}

namespace {

class SoftwareRenderer final : public Renderer {
 public:
  Result<void> draw(const DrawList& list, const FrameOptions& options, Image& out) const override {
    out = render_image(list, options);
    return {};
  }
  Result<void> draw(const DrawList& list, const FrameOptions& options,
                    LinearImage& out) const override {
    out = render_linear(list, options);
    return {};
  }
  std::string description() const override { return "software"; }
};

}  // namespace

extern const Backend software_backend = {
    "software", "exact coverage; the same bytes on every machine", [](const BackendChoice&) {
      return Result<std::unique_ptr<Renderer>>(std::make_unique<SoftwareRenderer>());
    }};

}  // namespace flatray
