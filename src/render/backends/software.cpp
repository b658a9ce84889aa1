#include <algorithm>

#include "base/parallel.h"
#include "render/backend.h"
#include "render/band_painter.h"
#include "render/flat_painter.h"

namespace flatray {
namespace {

constexpr std::size_t kBandsATask = 4;  // which share their room; one thread does all in one

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

int channels_of(const Image& image) { return image.channels; }
int channels_of(const LinearImage&) { return 0; }

// A band to draw into the rows of a picture from `y` on.
struct BandTask {
  const PixelBox box;
  const Band& band;
  const StillBand* still;  // its lowest items, or null
  int y;

  std::size_t first() const { return still == nullptr ? 0 : still->items(); }
};

// The two ways to draw give the same pixels. Light, all that shall be drawn even if hidden, and
// bands with gradients or layers go by blending every item in order.
class BandsOfTask {
 public:
  BandsOfTask(const DrawList& list, const FrameOptions& options, DrawCounts& counts)
      : flat_(list, options.stop),
        blended_(list, !options.keep_all, options.stop),
        plain_(!options.keep_all),
        counts_(counts) {}
  BandsOfTask(const BandsOfTask&) = delete;
  BandsOfTask& operator=(const BandsOfTask&) = delete;
  ~BandsOfTask() { counts_.scans += flat_.scans() + blended_.scans(); }

  template <class Picture>
  void draw(const BandTask& task, Picture& out) {
    const std::size_t hidden = paint(task, out);
    ++counts_.bands;
    counts_.items += task.band.size();
    counts_.hidden_items += hidden;
    if (hidden < task.first()) counts_.still_items += task.first() - hidden;
  }

  void keep(const PixelBox& box, const Band& band, std::size_t items, int channels,
            StillBand& out) {
    out.keep(items, blended_.paint(box, band, items, nullptr, 0), channels);
  }

 private:
  std::size_t paint(const BandTask& task, Image& out) {
    if (plain_ && task.band.flat_from() <= task.first())
      if (const auto hidden = flat_.paint(task.box, task.band, task.still, task.y, out))
        return *hidden;
    return blend(task, out);
  }
  std::size_t paint(const BandTask& task, LinearImage& out) { return blend(task, out); }

  template <class Picture>
  std::size_t blend(const BandTask& task, Picture& out) {
    develop(blended_.paint(task.box, task.band, task.band.size(), task.still, task.y), out);
    return blended_.hidden();
  }

  FlatPainter flat_;
  BandPainter blended_;
  const bool plain_;
  DrawCounts& counts_;
};

// `still` may be null; its bands are made and used.
template <class Picture>
DrawCounts draw_bands(const DrawList& list, const Bands& bands,
                      const std::vector<BandChange>& changes, StillLayer* still,
                      const FrameOptions& options, Picture& out) {
  const std::size_t each =
      options.threads == 1 ? std::max<std::size_t>(bands.count(), 1) : kBandsATask;
  const std::size_t tasks = (bands.count() + each - 1) / each;
  std::vector<DrawCounts> counts(tasks);
  const int top = crop_of(list, options).y;
  parallel_for(tasks, options.threads, [&](std::size_t task) {
    BandsOfTask painter(list, options, counts[task]);
    Band items;
    const std::size_t end = std::min(bands.count(), (task + 1) * each);
    for (std::size_t band = task * each; band < end; ++band) {
      if (options.stopped()) {
        counts[task].stopped_bands += end - band;
        return;
      }
      if (changes[band].unchanged) {
        ++counts[task].kept_bands;
        continue;
      }
      const PixelBox box = bands.box(band);
      bands.list(band, items);
      StillBand* const below = still == nullptr ? nullptr : &(*still)[band];
      if (below != nullptr && still->wanted(band) > 0)
        painter.keep(box, items, still->wanted(band), channels_of(out), *below);
      const bool kept = below != nullptr && below->items() > 0;
      painter.draw({box, items, kept ? below : nullptr, box.y - top}, out);
      if (options.stopped()) {  // perhaps within the band
        counts[task].stopped_bands += end - band;
        return;
      }
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
  if (options_.keep_all)
    changes_.assign(bands.count(), {});
  else
    changes_ = compare_bands(list, bands, list_, bands_);
  list_ = std::move(list);
  bands_ = std::move(bands);
  still_.follow(bands_, changes_);
  shape_picture(crop, list_, picture_);
  counts_ += draw_bands(list_, bands_, changes_, &still_, options_, picture_);
  changed_ = changed(0, crop.height);
  return picture_;
}

template <class Picture>
bool FrameDrawer<Picture>::changed(int begin, int end) const {
  const int top = crop_of(list_, options_).y;
  for (std::size_t i = 0; i < changes_.size(); ++i) {
    const PixelBox box = bands_.box(i);
    if (!changes_[i].unchanged && box.y - top < end && box.y - top + box.height > begin)
      return true;
  }
  return false;
}

template class FrameDrawer<Image>;
template class FrameDrawer<LinearImage>;

template <class Picture>
void render_into(const DrawList& list, const FrameOptions& options, Picture& picture) {
  const PixelBox crop = crop_of(list, options);
  const Bands bands(list, crop);
  shape_picture(crop, list, picture);
  draw_bands(list, bands, std::vector<BandChange>(bands.count()), nullptr, options, picture);
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
