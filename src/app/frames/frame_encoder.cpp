#include "app/frames/frame_encoder.h"

#include "app/frames/light_files.h"
#include "base/hash.h"

namespace flatray {
namespace {

std::string hash_of(const Image& image) { return pixel_hash(image); }
std::string hash_of(const LinearImage& image) {
  return Hash().add(std::as_bytes(std::span(image.pixels))).hex();
}

std::string hash_of(const FilmFile& film) {
  Hash hash;
  for (const FilmFile::Scramble& one : film.scrambles) hash.add(std::as_bytes(std::span(one.sums)));
  return hash.hex();
}

bool all_changed(int, int) { return true; }

}  // namespace

FrameEncoder::FrameEncoder(const RenderJob& job, unsigned threads, bool (*stop)())
    : job_(job),
      options_{job.crop, threads, job.keep_all, stop, &report_},
      drawer_(job.output.format().of_picture != nullptr ? Drawer(FrameDrawer<Image>(options_))
                                                        : FrameDrawer<LinearImage>(options_)),
      png_(threads) {
  out_.record.scene = job.fingerprint();
  out_.record.seed = job.seed;
  out_.record.backend = job.backend();
}

Result<const Encoded*> FrameEncoder::encode(const RenderPlan& plan, const Timeline& timeline,
                                            unsigned frame) {
  if (job_.output.format().of_film != nullptr) return encode_film(plan, timeline, frame);
  if (job_.view) {
    const Image picture =
        draw_view(*job_.view, job_.tracer, timeline.scene(), at(timeline, frame), options_);
    if (options_.stopped()) return nullptr;
    keep(picture, all_changed);
    return &out_;
  }
  FLATRAY_TRY(list, draw_list(plan, timeline, frame, options_));
  FLATRAY_TRY(drawn,
              std::visit([&](auto& drawer) { return encode(drawer, std::move(*list)); }, drawer_));
  keep_report();
  if (job_.renderer) return options_.stopped() ? nullptr : &out_;
  return std::visit([](const auto& drawer) { return drawer.whole(); }, drawer_) ? &out_ : nullptr;
}

template <class Picture>
Result<void> FrameEncoder::encode(FrameDrawer<Picture>& drawer, DrawList list) {
  if (job_.renderer) {
    Picture picture;
    if (auto drawn = job_.renderer->draw(list, options_, picture); !drawn) return drawn;
    keep(picture, all_changed);
    return {};
  }
  const Picture& picture = drawer.draw(std::move(list));
  if (drawer.changed() && drawer.whole())
    keep(picture, [&drawer](int begin, int end) { return drawer.changed(begin, end); });
  return {};
}

// Of light, and of its error.
void FrameEncoder::keep_report() {
  if (job_.scene.lamps.empty()) return;
  out_.record.light = record_of(report_);
  if (!job_.light.error_image || options_.stopped()) return;
  out_.error_bytes =
      error_picture(report_, job_.light.error_image->format(),
                    {0, 0, job_.scene.film.width, job_.scene.film.height}, job_.picture());
  out_.record.error_image = Hash().add(out_.error_bytes).hex();
}

Result<const Encoded*> FrameEncoder::encode_film(const RenderPlan& plan, const Timeline& timeline,
                                                 unsigned frame) {
  FLATRAY_TRY(film, traced_film(job_, plan, timeline, frame, options_));
  if (!*film) return nullptr;
  keep(**film, all_changed);
  report_ = report_of(**film);
  keep_report();
  return &out_;
}

template <class Picture>
void FrameEncoder::keep(const Picture& picture, const RowsChanged& changed) {
  const PictureFormat& format = job_.output.format();
  if constexpr (std::is_same_v<Picture, Image>)
    out_.bytes = format.of_picture(picture, png_, changed);
  else if constexpr (std::is_same_v<Picture, LinearImage>)
    out_.bytes = format.of_light(picture);
  else
    out_.bytes = format.of_film(picture);
  out_.record.pixels = hash_of(picture);
  out_.record.width = picture.width;
  out_.record.height = picture.height;
  if (format.part == nullptr) out_.record.bytes = Hash().add(out_.bytes).hex();
  ++encoded_;
}

const DrawCounts& FrameEncoder::counts() const {
  return std::visit([](const auto& drawer) -> const DrawCounts& { return drawer.counts(); },
                    drawer_);
}

}  // namespace flatray
