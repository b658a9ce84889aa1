#include <algorithm>
#include <array>
#include <bit>

#include "base/parallel.h"
#include "render/backend.h"
#include "render/coverage/band_scan.h"
#include "render/frame.h"

namespace flatray {
namespace {

constexpr std::size_t kBandsATask = 4;  // which share their room; one thread does all in one

// Of the rows of a band. Neighbours of one light are written together; what is of one pixel waits
// for the end of the band, when all are developed one after another.
class ImageSink final : public PixelSink {
 public:
  ImageSink(Image& out, const PixelBox& crop)
      : out_(out), crop_(crop), channels_(static_cast<std::size_t>(out.channels)) {}

  void begin(const PixelBox& band) { first_ = out_.at(0, band.y - crop_.y), top_ = band.y; }
  void run(int y, int begin, int end, const Light& light) override {
    put_run(shown(light), channels_ * static_cast<std::size_t>(end - begin),
            first_ + channels_ * place(y, begin));
  }
  void pixel(int y, int x, const Light& light) override {
    lights_.push_back(light);
    places_.push_back(place(y, x));
  }
  void end() {
    put_pixels(lights_, places_, out_.channels, first_);
    lights_.clear(), places_.clear();
  }

 private:
  // Few lights take turns.
  const ShownColour& shown(const Light& light) {
    const auto bits = std::bit_cast<std::array<std::uint32_t, 4>>(light);
    auto& [of, colour] = shown_[((bits[0] ^ bits[1] * 3 ^ bits[2] * 5) * 0x9e3779b9U) >> 26];
    if (of != light) colour = shown_colour(of = light, out_.channels);
    return colour;
  }

  std::uint32_t place(int y, int x) const {
    return static_cast<std::uint32_t>((y - top_) * crop_.width + (x - crop_.x));
  }

  Image& out_;
  const PixelBox crop_;
  const std::size_t channels_;
  std::uint8_t* first_ = nullptr;
  int top_ = 0;
  struct Shown {
    Light of{-1, -1, -1, -1};
    ShownColour colour{};
  };
  std::array<Shown, 64> shown_;
  std::vector<Light> lights_;
  std::vector<std::uint32_t> places_;
};

class LinearSink final : public PixelSink {
 public:
  LinearSink(LinearImage& out, const PixelBox& crop) : out_(out), crop_(crop) {}

  void begin(const PixelBox&) {}
  void run(int y, int begin, int end, const Light& light) override {
    for (int x = begin; x < end; ++x) pixel(y, x, light);
  }
  void pixel(int y, int x, const Light& light) override {
    const auto row = static_cast<std::size_t>(y - crop_.y) * static_cast<std::size_t>(crop_.width);
    std::copy_n(light.data(), 3,
                out_.pixels.data() + 3 * (row + static_cast<std::size_t>(x - crop_.x)));
  }
  void end() {}

 private:
  LinearImage& out_;
  const PixelBox crop_;
};

ImageSink sink_of(Image& out, const PixelBox& crop) { return {out, crop}; }
LinearSink sink_of(LinearImage& out, const PixelBox& crop) { return {out, crop}; }

template <class Picture>
DrawCounts draw_bands(const DrawList& list, const Bands& bands,
                      const std::vector<BandChange>& changes, const FrameOptions& options,
                      Picture& out) {
  const std::size_t each =
      options.threads == 1 ? std::max<std::size_t>(bands.count(), 1) : kBandsATask;
  const std::size_t tasks = (bands.count() + each - 1) / each;
  std::vector<DrawCounts> counts(tasks);
  parallel_for(tasks, options.threads, [&](std::size_t task) {
    BandScan scan(list, !options.keep_all, options.stop);
    auto sink = sink_of(out, crop_of(list, options));
    DrawCounts& count = counts[task];
    Band items;
    const std::size_t end = std::min(bands.count(), (task + 1) * each);
    for (std::size_t band = task * each; band < end; ++band) {
      if (changes[band].unchanged()) {
        ++count.kept_bands;
        continue;
      }
      const PixelBox all = bands.box(band);
      const auto [from, to] = changes[band];
      bands.list(band, items);
      sink.begin(all);
      scan.scan({from, all.y, to - from, all.height}, items, sink);
      sink.end();
      if (options.stopped()) {  // perhaps within the band
        count.stopped_bands += end - band;
        break;
      }
      const auto height = static_cast<std::uint64_t>(all.height);
      ++count.bands;
      count.items += items.size();
      count.hidden_items += scan.hidden();
      count.pixels += height * static_cast<std::uint64_t>(all.width);
      count.kept_pixels += height * static_cast<std::uint64_t>(all.width - (to - from));
    }
    count.scans = scan.scans();
  });
  DrawCounts sum;
  for (const DrawCounts& one : counts) sum += one;
  return sum;
}

}  // namespace

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

template <class Picture>
const Picture& FrameDrawer<Picture>::draw(DrawList list) {
  const PixelBox crop = crop_of(list, options_);
  Bands bands(list, crop);
  if (options_.keep_all)
    changes_ = whole_bands(bands);
  else
    changes_ = compare_bands(list, bands, list_, bands_);
  list_ = std::move(list);
  bands_ = std::move(bands);
  shape_picture(crop, list_, picture_);
  counts_ += draw_bands(list_, bands_, changes_, options_, picture_);
  changed_ = changed(0, crop.height);
  return picture_;
}

template <class Picture>
bool FrameDrawer<Picture>::changed(int begin, int end) const {
  const int top = crop_of(list_, options_).y;
  for (std::size_t i = 0; i < changes_.size(); ++i) {
    const PixelBox box = bands_.box(i);
    if (!changes_[i].unchanged() && box.y - top < end && box.y - top + box.height > begin)
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
  draw_bands(list, bands, whole_bands(bands), options, picture);
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
    render_into(list, options, out);
    return {};
  }
  Result<void> draw(const DrawList& list, const FrameOptions& options,
                    LinearImage& out) const override {
    render_into(list, options, out);
    return {};
  }
  std::string description() const override { return "software"; }
};

}  // namespace

namespace software_backend {
extern const Backend entry = {
    "software", "exact coverage; the same bytes on every machine", [](const BackendChoice&) {
      return Result<std::unique_ptr<Renderer>>(std::make_unique<SoftwareRenderer>());
    }};

}  // namespace software_backend

}  // namespace flatray
