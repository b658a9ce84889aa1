#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <vector>

#include "collide/scene_timeline.h"
#include "flatray/picture.h"
#include "image/png.h"
#include "render/frame.h"
#include "scene/keys/build_scene.h"
#include "scene/load.h"

namespace flatray::api {
namespace {

struct Drawn {
  Image image;
  Diagnostics warnings;
};

Result<Drawn> drawn(std::string_view name, std::string_view text, unsigned frame,
                    unsigned threads) {
  if (frame < 1 || frame > kLastFrame)
    return fail(named_place(std::string(name)), fmt::format("there is no frame {}", frame),
                fmt::format("frames run from 1 to {}", kLastFrame));
  FLATRAY_TRY(loaded, load_scene_text(std::string(name), std::string(text)));
  const Scene& scene = loaded->scene;
  FLATRAY_TRY(timeline, make_timeline(scene, scene.seed, frame));
  const FrameOptions options{.crop = {}, .threads = std::max(1U, threads)};
  FLATRAY_TRY(list, draw_list(make_plan(scene, false), *timeline, frame, options));
  return Drawn{render_image(*list, options), std::move(loaded->warnings)};
}

}  // namespace

struct Picture::Data {
  Image image;
  std::string messages;
  std::vector<std::uint8_t> png;
};

Picture::Picture() = default;
Picture::Picture(Picture&&) noexcept = default;
Picture& Picture::operator=(Picture&&) noexcept = default;
Picture::~Picture() = default;

Picture::Data& Picture::data() {
  if (!data_) data_ = Owned<Data>(new Data);
  return *data_;
}

bool Picture::draw(std::string_view name, std::string_view text, unsigned frame, unsigned threads) {
  Result<Drawn> result = drawn(name, text, frame, threads);
  Data& mine = data();
  mine.messages = result ? format(result->warnings, "warning") : format(result.error());
  mine.image = result ? std::move(result->image) : Image();
  mine.png.clear();
  return result.has_value();
}

std::string_view Picture::messages() const { return data_ ? data_->messages : std::string_view(); }
int Picture::width() const { return data_ ? data_->image.width : 0; }
int Picture::height() const { return data_ ? data_->image.height : 0; }
int Picture::channels() const { return data_ ? data_->image.channels : 3; }

std::span<const std::uint8_t> Picture::pixels() const {
  return data_ ? std::span<const std::uint8_t>(data_->image.pixels)
               : std::span<const std::uint8_t>();
}

std::span<const std::uint8_t> Picture::png(unsigned threads) {
  if (pixels().empty()) return {};
  const std::vector<std::byte> bytes = encode_png(data_->image, std::max(1U, threads));
  data_->png.resize(bytes.size());
  std::transform(bytes.begin(), bytes.end(), data_->png.begin(),
                 [](std::byte byte) { return std::to_integer<std::uint8_t>(byte); });
  return data_->png;
}

}  // namespace flatray::api
