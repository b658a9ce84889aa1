#include <fmt/core.h>

#include <algorithm>

#include "app/frames/render_job.h"
#include "app/frames/video_maker.h"
#include "app/help/version.h"
#include "app/options/resource_limits.h"
#include "base/hash.h"
#include "base/json.h"
#include "base/number_text.h"
#include "base/parallel.h"
#include "render/light/light_picture.h"

namespace flatray {
namespace {

// Frames are drawn side by side as long as their pictures together stay under this.
constexpr std::uint64_t kMemoryAtOnce = std::uint64_t{1} << 30;

std::uint64_t pixels_of(const RenderJob& job) {
  const PixelBox box = job.picture();
  return static_cast<std::uint64_t>(box.width) * static_cast<std::uint64_t>(box.height);
}

// What one picture takes at its peak, for pixels that do not compress. Not what the scene and its
// outlines take.
std::uint64_t bytes_of_frame(const RenderJob& job) {
  const PictureFormat& format = job.output.format();
  const std::uint64_t bytes =
      format.of_picture != nullptr ? (job.scene.film.background.a == 255 ? 3 : 4)
      : format.of_light != nullptr ? 3 * sizeof(float)
                                   : 3 * sizeof(std::int64_t) * job.scene.light.scrambles;
  // The picture, what is made of it, and the growing file, or of videos pictures that wait.
  const std::uint64_t times = format.part == nullptr ? 3 : 3 + 2 * frames_a_turn(job);
  const std::uint64_t light =
      job.scene.lamps.empty() || job.view ? 0 : light_bytes(job.scene, hardware_threads());
  return times * pixels_of(job) * bytes + light;
}

}  // namespace

std::size_t frames_a_turn(const RenderJob& job) {
  constexpr std::uint64_t kPixels = std::uint64_t{1} << 22, kMost = 8;
  return std::clamp<std::uint64_t>(kPixels / pixels_of(job), 1, kMost);
}

Fields RenderJob::setting() const {
  const PixelBox part = picture();
  Fields fields{{"scene", Hash().add(scene.hash).hex()},
                {"seed", seed},
                {"size", fmt::format("{}x{}", scene.film.width, scene.film.height)},
                {"part", fmt::format("{}x{} at {},{}", part.width, part.height, part.x, part.y)},
                {"format", output.format().name},
                {"backend", backend()},
                {"version", kVersion}};
  if (view)
    fields.emplace_back("view",
                        fmt::format("{} {} {}", view->view->name, number_text(view->point.x()),
                                    number_text(view->point.y())));
  if (tracer != nullptr && !tracer->exact) fields.emplace_back("tracer", tracer->name);
  // What the command line says of light, whatever the scene does.
  if (light.any()) {
    fields.emplace_back("rays", scene.light.rays);
    fields.emplace_back("scrambles", scene.light.scrambles);
  }
  if (light.estimator) fields.emplace_back("estimator", static_cast<int>(*light.estimator));
  if (light.error > 0) fields.emplace_back("error", light.error);
  if (light.seconds < kInfinity) fields.emplace_back("time", light.seconds);
  return fields;
}

Fields RenderJob::film_setting(unsigned frame) const {
  const LightSettings& rules = scene.light;
  Fields fields{{"scene", Hash().add(scene.hash).hex()},
                {"seed", seed},
                {"frame", frame},
                {"size", fmt::format("{}x{}", scene.film.width, scene.film.height)},
                {"scrambles", rules.scrambles},
                {"exposure", rules.exposure ? JsonValue(*rules.exposure) : "auto"},
                {"tone", flatray::name(rules.tone)},
                {"gamma", rules.gamma},
                {"version", kVersion}};
  if (tracer != nullptr && !tracer->exact) fields.emplace_back("tracer", tracer->name);
  return fields;
}

std::string RenderJob::fingerprint() const { return Hash().add(json_text(setting())).hex(); }

bool RenderJob::makes(const FrameRecord& record) const {
  return std::ranges::binary_search(frames, record.frame) && names(record);
}

Spread spread(const RenderJob& job, std::size_t frame_count, unsigned threads) {
  const std::uint64_t memory = std::min(kMemoryAtOnce, memory_limit() / 2);
  const std::uint64_t fit = std::max<std::uint64_t>(memory / bytes_of_frame(job), 1);
  const std::uint64_t at_once =
      std::min({std::uint64_t{threads}, fit, std::max<std::uint64_t>(frame_count, 1)});
  return {static_cast<unsigned>(at_once), static_cast<unsigned>(threads / at_once)};
}

std::uint64_t picture_bytes_at_once(const RenderJob& job, std::size_t frame_count,
                                    unsigned threads) {
  return spread(job, frame_count, threads).frames_at_once * bytes_of_frame(job);
}

}  // namespace flatray
